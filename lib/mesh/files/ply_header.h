/// \file The header of a PLY file: the elements of the file and how they are stored.
#pragma once

#include "mesh/files/text_lines.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace qm {

enum class PlyFormat { ascii, littleEndian, bigEndian };

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

/// The meaning of a property for a mesh.
enum class PlyRole { other, x, y, z, corners, strips };

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

/// Reads a header, in which vertices must have coordinates, and faces and strips of triangles must have
/// corners.
/// \param lines  at the beginning of the file; afterwards at the beginning of the body
/// \throw Error  with the number of the line
[[nodiscard]] PlyHeader readPlyHeader(TextLines& lines);

} // namespace qm
