#include "mesh/read_mesh.h"

#include "base/error.h"
#include "mesh/build_mesh.h"
#include "mesh/suspicions.h"
#include "mesh/text_lines.h"
#include "mesh/validate.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace qm {
namespace {

enum class Format { unknown, obj, off, ply };

Format formatNamed(std::string_view name) {
    const std::size_t dot = name.find_last_of("./");
    if (dot == std::string_view::npos || name[dot] == '/') return Format::unknown;
    std::string extension(name.substr(dot + 1));
    std::ranges::transform(extension, extension.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (extension == "obj") return Format::obj;
    if (extension == "off") return Format::off;
    if (extension == "ply") return Format::ply;
    return Format::unknown;
}

Format formatOf(std::string_view bytes) {
    constexpr std::array<std::string_view, 11> objStatements{"v", "vt", "vn",     "vp",     "f", "o",
                                                             "g", "s",  "mtllib", "usemtl", "l"};
    const std::string_view word = TextLines(bytes).wordAnywhere();
    if (word == "ply") return Format::ply;
    if (word.ends_with("OFF")) return Format::off;
    return std::ranges::find(objStatements, word) != objStatements.end() ? Format::obj : Format::unknown;
}

Soup readSoup(std::string_view bytes, std::string_view name) {
    if (bytes.empty()) throw Error("", "the file is empty", "Get it whole");
    if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3); // the mark that some editors set
    Format format = formatNamed(name);
    if (format == Format::unknown) format = formatOf(bytes);
    switch (format) {
    case Format::obj:
        return readObj(bytes);
    case Format::off:
        return readOff(bytes);
    case Format::ply:
        return readPly(bytes);
    case Format::unknown:
        break;
    }
    throw Error("", "the format is not known", "Give an OBJ, OFF or PLY file");
}

} // namespace

ReadResult readMesh(std::string_view bytes, std::string_view name, const ReadOptions& options) {
    Soup soup = readSoup(bytes, name);
    ReadResult result;
    if (options.repair) {
        validateElements(soup);
        result.repair = repairSoup(soup);
    }
    result.mesh = buildMesh(soup);
    result.warnings = suspicions(result.mesh);
    return result;
}

} // namespace qm
