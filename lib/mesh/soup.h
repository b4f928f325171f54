/// \file A polygon soup: what a file says, before anything is asked of it.
#pragma once

#include "mesh/quad_mesh.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace qm {

/// Points and polygons in file order. Indices may be out of range; polygons may have any number of vertices.
struct Soup {
    std::vector<Point> points;
    std::vector<std::int64_t> corners;      ///< vertex indices from 0, polygon after polygon
    std::vector<std::size_t> faceBegins{0}; ///< where polygon k begins in `corners`; one more than polygons
    std::vector<std::uint32_t> pointLines; ///< line of each point in the file, from 1; empty for binary files
    std::vector<std::uint32_t> faceLines;  ///< likewise of each polygon

    [[nodiscard]] std::size_t faceCount() const { return faceBegins.size() - 1; }
    [[nodiscard]] std::span<const std::int64_t> face(std::size_t k) const {
        return {corners.data() + faceBegins[k], corners.data() + faceBegins[k + 1]};
    }
    void endFace(std::uint32_t line);

    /// "vertex 7 (line 12)", for messages.
    [[nodiscard]] std::string pointPlace(std::size_t k) const;
    [[nodiscard]] std::string facePlace(std::size_t k) const;
};

/// \throw Error  naming the line, if the text is no OBJ or is cut off. Relative indices, texture and normal
/// indices,
///               colours, continued lines and any line ends are understood; other statements are passed over.
[[nodiscard]] Soup readObj(std::string_view text);

/// \throw Error  naming the line, if the text is no ASCII OFF or is cut off. Colours and normals are passed
/// over, and
///               a face may be spread over lines.
[[nodiscard]] Soup readOff(std::string_view text);

/// \throw Error  if the bytes are no PLY, ASCII or binary of either byte order, or are cut off
[[nodiscard]] Soup readPly(std::string_view bytes);

} // namespace qm
