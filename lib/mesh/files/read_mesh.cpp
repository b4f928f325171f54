#include "mesh/files/read_mesh.h"

#include "mesh/soup/build_mesh.h"
#include "mesh/soup/validate.h"

namespace qm {
ReadResult readMesh(std::string_view bytes, std::string_view name, const ReadOptions& options) {
    Soup soup = readSoup(bytes, name, 4);
    ReadResult result;
    if (options.repair) {
        validateElements(soup);
        result.repair = repairSoup(soup);
    }
    result.mesh = buildMesh(soup);
    return result;
}

} // namespace qm
