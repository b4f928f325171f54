#include "mesh/files/mesh_format.h"

#include "mesh/files/text_lines.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <utility>

namespace qm {

std::optional<MeshFormat> formatOfName(std::string_view name) {
    constexpr std::array<std::pair<std::string_view, MeshFormat>, 4> endings{{{"obj", MeshFormat::obj},
                                                                              {"off", MeshFormat::off},
                                                                              {"ply", MeshFormat::ply},
                                                                              {"stl", MeshFormat::stl}}};
    const std::size_t dot = name.find_last_of("./");
    if (dot == std::string_view::npos || name[dot] == '/') return std::nullopt;
    std::string ending(name.substr(dot + 1));
    std::ranges::transform(ending, ending.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    for (const auto& [text, format] : endings)
        if (ending == text) return format;
    return std::nullopt;
}

std::optional<MeshFormat> formatOfBytes(std::string_view bytes) {
    constexpr std::array<std::string_view, 11> objStatements{"v", "vt", "vn",     "vp",     "f", "o",
                                                             "g", "s",  "mtllib", "usemtl", "l"};
    const std::string_view word = TextLines(bytes).wordAnywhere();
    if (word == "ply") return MeshFormat::ply;
    if (word == "solid") return MeshFormat::stl;
    if (word.ends_with("OFF")) return MeshFormat::off;
    if (std::ranges::find(objStatements, word) != objStatements.end()) return MeshFormat::obj;
    return std::nullopt;
}

} // namespace qm
