#include "cli/scan_input.h"

#include "base/error.h"
#include "document/files.h"
#include "document/sha256.h"
#include "document/utf8.h"
#include "mesh/read_triangles.h"

namespace qm {

ScanInput readScanInput(const Tool& tool, const std::string& path) {
    ScanInput input;
    if (path.empty()) return input;
    tool.protect(path);
    inFile(path, [&] {
        if (!isUtf8(path))
            throw Error("", "its name is not UTF-8, so no document can refer to it", "Rename the file");
        const std::string bytes = readFile(path);
        input.file = {path, sha256(bytes)};
        input.surface.emplace(readTriangles(bytes, path));
    });
    tool.count("triangles", static_cast<double>(input.surface->size()));
    return input;
}

} // namespace qm
