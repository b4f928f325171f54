#include "cli/tools/scan_input.h"

#include "base/error.h"
#include "document/files/files.h"
#include "document/files/referenced_file.h"
#include "document/files/sha256.h"
#include "document/json/utf8.h"
#include "mesh/files/read_triangles.h"
#include "mesh/triangles/repair_triangles.h"

#include <cstddef>

namespace qm {
namespace {

/// Neighbouring triangles agree in it, if they can: normals tell the sides of thin walls apart.
TriangleSurface surfaceOf(const Tool& tool, const std::string& bytes, const std::string& path) {
    Triangles triangles = readTriangles(bytes, path);
    try {
        if (const std::size_t turned = orientTriangles(triangles); turned > 0)
            tool.warn(displayName(path) + ": " + std::to_string(turned) + " of " +
                      std::to_string(triangles.faces.size()) +
                      " triangles lie the wrong way round, and are turned over here");
    } catch (const Error&) { // one-sided: they stay as they are
    }
    return TriangleSurface(triangles);
}

} // namespace

ScanInput readScanInput(const Tool& tool, const std::string& path) {
    ScanInput input;
    if (path.empty()) return input;
    tool.protect(path);
    inFile(displayName(path), [&] {
        requireUtf8Name(path);
        const std::string bytes = readFile(path);
        input.file = {path, sha256(bytes)};
        input.surface = surfaceOf(tool, bytes, path);
    });
    tool.count("triangles", input.surface->size());
    return input;
}

std::optional<TriangleSurface> readRecordedScan(const Tool& tool, const Document& document,
                                                const std::string& path) {
    const std::string name = displayName(document.path);
    const auto section =
        document.has(Kind::surfaces) ? document.section(Kind::surfaces).find("scan") : std::nullopt;
    if (!section) {
        if (path.empty()) return {};
        throw FileError(name, "has no surfaces that were fitted to a scan", "Leave out --reference");
    }
    try {
        const ReferencedFile file = inFile(name, [&] {
            return findReferencedFile(*section, document.path, path,
                                      {"scan", "--reference FILE", "Fit again with qm-bspline"});
        });
        tool.protect(file.path);
        return inFile(file.path, [&] { return surfaceOf(tool, file.bytes, file.path); });
    } catch (const FileError& error) {
        if (!path.empty()) throw;
        tool.warn(std::string(error.what()) +
                  ". Until then every patch has the colour of its largest deviation");
        return {};
    }
}

} // namespace qm
