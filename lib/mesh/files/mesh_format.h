/// \file The file formats of meshes.
#pragma once

#include <optional>
#include <string_view>

namespace qm {

enum class MeshFormat { obj, off, ply, stl };

/// The format that a file name's extension stands for.
[[nodiscard]] std::optional<MeshFormat> formatOfName(std::string_view name);

/// The format that the first word of a file stands for. Binary STL begins with no such word.
[[nodiscard]] std::optional<MeshFormat> formatOfBytes(std::string_view bytes);

} // namespace qm
