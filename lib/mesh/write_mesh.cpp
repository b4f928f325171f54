#include "mesh/write_mesh.h"

#include "mesh/write_soup.h"

namespace qm {

std::string writeObj(const QuadMesh& mesh) {
    return writeSoup(soupOf(mesh), MeshFormat::obj);
}

} // namespace qm
