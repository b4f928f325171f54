/// \file The file formats that meshes come in.
#pragma once

#include <optional>
#include <string_view>

namespace qm {

enum class MeshFormat { obj, off, ply, stl };

/// What the ending of a file's name says.
[[nodiscard]] std::optional<MeshFormat> formatOfName(std::string_view name);

/// What the first word says. Binary STL has none.
[[nodiscard]] std::optional<MeshFormat> formatOfBytes(std::string_view bytes);

} // namespace qm
