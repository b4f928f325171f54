#include "document/mesh_section.h"

#include "base/error.h"
#include "document/files.h"
#include "document/sha256.h"
#include "document/utf8.h"
#include "mesh/read_mesh.h"

#include <unistd.h>
#include <vector>

namespace qm {

Json meshToJson(const std::string& path, std::string_view bytes, const QuadMesh& mesh) {
    if (!isUtf8(path))
        throw Error("", "its name is not UTF-8, so no document can refer to it", "Rename the file");
    return {{"path", path},
            {"sha256", sha256(bytes)},
            {"vertices", mesh.n_vertices()},
            {"faces", mesh.n_faces()}};
}

namespace {

bool exists(const std::string& path) {
    return access(path.c_str(), F_OK) == 0;
}

/// Where the mesh may be, the likeliest first.
std::vector<std::string> candidates(const std::string& recorded, const std::string& documentPath) {
    std::vector<std::string> paths{recorded};
    if (documentPath == "-") return paths;
    const std::string folder = documentPath.substr(0, documentPath.rfind('/') + 1);
    if (recorded.front() != '/' && !folder.empty()) paths.push_back(folder + recorded);
    // Whoever passes on a document puts the mesh beside it.
    paths.push_back(folder + recorded.substr(recorded.rfind('/') + 1));
    return paths;
}

struct MeshFile {
    std::string path;
    std::string bytes;
};

MeshFile findMesh(const JsonPlace& section, const std::string& documentPath, const std::string& meshPath) {
    const std::string& recorded = section["path"].text();
    const std::string& fingerprint = section["sha256"].text();
    const std::string remedy = "Name the mesh with --mesh FILE";
    if (meshPath.empty() && recorded == "-")
        section["path"].fail("the mesh came from standard input, so it is not known where it is", remedy);
    if (meshPath.empty() && (recorded.empty() || recorded.find('\0') != std::string::npos))
        section["path"].fail("is no name of a file", remedy);

    std::string changed; // a file of that name with other contents
    const std::vector<std::string> paths =
        meshPath.empty() ? candidates(recorded, documentPath) : std::vector<std::string>{meshPath};
    for (const std::string& path : paths) {
        if (!exists(path)) continue;
        if (!isRegularFile(path))
            throw FileError(path,
                            "the mesh that " + displayName(documentPath) +
                                " refers to is no file but a folder, a pipe or a device",
                            remedy);
        MeshFile file{path, readFile(path)};
        if (sha256(file.bytes) == fingerprint) return file;
        if (changed.empty()) changed = path;
    }
    if (!changed.empty())
        throw FileError(changed, "the mesh has changed since " + displayName(documentPath) + " was made",
                        "Begin again with qm-basecomplex, or name the right mesh with --mesh FILE");
    throw FileError(paths.front(), "the mesh that " + displayName(documentPath) + " refers to is not there",
                    remedy);
}

void verifyCount(const JsonPlace& place, std::size_t count) {
    if (place.whole() != static_cast<std::int64_t>(count))
        place.fail("the mesh has " + std::to_string(count), "Begin again with qm-basecomplex");
}

} // namespace

FoundMesh readMeshOf(const JsonPlace& section, const std::string& documentPath, const std::string& meshPath) {
    const MeshFile file = findMesh(section, documentPath, meshPath);
    ReadResult result = inFile(file.path, [&] { return readMesh(file.bytes, file.path); });
    verifyCount(section["vertices"], result.mesh.n_vertices());
    verifyCount(section["faces"], result.mesh.n_faces());
    return {std::move(result.mesh), file.path};
}

} // namespace qm
