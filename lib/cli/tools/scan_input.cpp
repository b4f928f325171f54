#include "cli/tools/scan_input.h"

#include "base/error.h"
#include "document/files/files.h"
#include "document/files/referenced_file.h"
#include "document/files/sha256.h"
#include "document/json/utf8.h"
#include "mesh/files/read_triangles.h"

namespace qm {

ScanInput readScanInput(const Tool& tool, const std::string& path) {
    ScanInput input;
    if (path.empty()) return input;
    tool.protect(path);
    inFile(path, [&] {
        requireUtf8Name(path);
        const std::string bytes = readFile(path);
        input.file = {path, sha256(bytes)};
        input.surface.emplace(readTriangles(bytes, path));
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
        return inFile(file.path, [&] { return TriangleSurface(readTriangles(file.bytes, file.path)); });
    } catch (const FileError& error) {
        if (!path.empty()) throw;
        tool.warn(std::string(error.what()) +
                  ". Until then every patch has the colour of its largest deviation");
        return {};
    }
}

} // namespace qm
