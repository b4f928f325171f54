/// \file The header of a PLY file: which elements it holds, and how they are stored.
#pragma once

#include "mesh/text_lines.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace qm {

enum class PlyFormat { ascii, littleEndian, bigEndian };

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

/// What a property is for a mesh.
enum class PlyRole { other, x, y, z, corners };

struct PlyProperty {
    PlyRole role = PlyRole::other;
    PlyType type{};
    std::optional<PlyType> countType; ///< of a list
};

struct PlyElement {
    std::string name;
    std::size_t count = 0;
    std::vector<PlyProperty> properties;
};

struct PlyHeader {
    PlyFormat format{};
    std::vector<PlyElement> elements; ///< in the order in which they are stored
};

/// Vertices have places and faces have corners.
/// \param lines  at the beginning; afterwards the body follows
/// \throw Error  naming the line
[[nodiscard]] PlyHeader readPlyHeader(TextLines& lines);

} // namespace qm
