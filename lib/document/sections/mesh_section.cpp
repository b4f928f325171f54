#include "document/sections/mesh_section.h"

#include "document/files/files.h"
#include "document/files/referenced_file.h"
#include "document/files/sha256.h"
#include "document/json/utf8.h"
#include "mesh/files/read_mesh.h"

#include <utility>

namespace qm {

Json meshToJson(const std::string& path, std::string_view bytes, const QuadMesh& mesh) {
    requireUtf8Name(path);
    return {{"path", path},
            {"sha256", sha256(bytes)},
            {"vertices", mesh.n_vertices()},
            {"faces", mesh.n_faces()}};
}

namespace {

void verifyCount(const JsonPlace& place, std::size_t count) {
    if (std::cmp_not_equal(place.whole(), count))
        place.fail("the mesh has " + std::to_string(count), "Begin again with qm-basecomplex");
}

} // namespace

FoundMesh readMeshOf(const JsonPlace& section, const std::string& documentPath, const std::string& meshPath) {
    const ReferencedFile file = findReferencedFile(
        section, documentPath, meshPath, {"mesh", "--mesh FILE", "Begin again with qm-basecomplex"});
    ReadResult result = inFile(file.path, [&] { return readMesh(file.bytes, file.path); });
    verifyCount(section["vertices"], result.mesh.n_vertices());
    verifyCount(section["faces"], result.mesh.n_faces());
    return {std::move(result.mesh), file.path};
}

} // namespace qm
