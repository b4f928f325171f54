#include "support/shared_meshes.h"

#include "mesh/files/read_mesh.h"
#include "support/shared_files.h"

namespace qm::test {

std::optional<check::CheckedMesh> sharedMesh(const std::string& name) {
    const auto bytes = sharedFile(name);
    if (!bytes) return std::nullopt;
    return check::checkedMesh(readMesh(*bytes, name).mesh);
}

} // namespace qm::test
