#include "mesh/read_mesh.h"

#include "mesh/build_mesh.h"
#include "mesh/validate.h"

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
