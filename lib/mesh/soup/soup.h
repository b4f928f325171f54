/// \file A polygon soup: the unchecked contents of a file.
#pragma once

#include "mesh/quad_mesh.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace qm {

/// Points and polygons in file order. Indices may be out of range; polygons may have any number of vertices.
struct Soup {
    std::vector<Point> points;
    std::vector<std::int64_t> corners;      ///< vertex indices from 0, polygon after polygon
    std::vector<std::size_t> faceBegins{0}; ///< where polygon k begins in `corners`; one more than polygons

    // For messages, which name the elements of the file, whatever has been done to the soup since.
    std::vector<std::uint32_t> pointLines;   ///< line of each point, from 1; empty for binary files
    std::vector<std::uint32_t> faceLines;    ///< likewise of each polygon
    std::vector<std::uint32_t> pointNumbers; ///< number in the file; empty if that is the position
    std::vector<std::uint32_t> faceNumbers;  ///< likewise of each polygon
    std::int64_t firstIndex = 0;             ///< of the vertices of a polygon in the file

    [[nodiscard]] std::size_t faceCount() const { return faceBegins.size() - 1; }
    [[nodiscard]] std::span<const std::int64_t> face(std::size_t k) const {
        return {corners.data() + faceBegins[k], corners.data() + faceBegins[k + 1]};
    }
    /// The polygon that a corner belongs to; takes logarithmic time.
    [[nodiscard]] std::size_t faceOf(std::size_t corner) const;
    /// Makes the corners that were added since the last polygon a new one.
    /// \param line  0 if there are no lines
    void endFace(std::uint32_t line);
    /// Adds a polygon that has no line.
    /// \param added  whole numbers, the indices of its vertices
    template <class Corners> void addFace(const Corners& added) {
        corners.insert(corners.end(), added.begin(), added.end());
        endFace(0);
    }

    /// The number of a point in the file.
    [[nodiscard]] std::size_t pointNumber(std::size_t k) const;
    /// "vertex 7 (line 12)".
    [[nodiscard]] std::string pointPlace(std::size_t k) const;
    /// "face 7 (line 12)".
    [[nodiscard]] std::string facePlace(std::size_t k) const;
};

/// Reads OBJ. Relative indices, texture and normal indices, colours, continued lines and all line ends are
/// understood; other statements are ignored.
/// \param sides  a face at the end of the text with fewer sides, and fewer than the one before it, counts as
/// truncated
/// \throw Error  with the line, if the text is no OBJ, is truncated or holds zero bytes
[[nodiscard]] Soup readObj(std::string_view text, std::size_t sides);

/// Reads OFF. Colours and normals are ignored, and a face may extend over several lines.
/// \throw Error  with the line, if the text is no ASCII OFF, or does not have the size that its header says
[[nodiscard]] Soup readOff(std::string_view text);

/// Reads PLY, ASCII or binary in either byte order: vertices, faces and strips of triangles; everything
/// except their coordinates and corners is ignored.
/// \throw Error  if the bytes are no PLY, or do not have the size that their header says
[[nodiscard]] Soup readPly(std::string_view bytes);

/// Reads STL, text or binary. Every facet gets its own points.
/// \throw Error  if the bytes are no STL, or do not have the size that they announce
[[nodiscard]] Soup readStl(std::string_view bytes);

/// Reads any of these formats.
/// \param name  of the file; its extension determines the format, or, if there is none, the first word
/// \param sides  that faces should have
/// \throw Error  as above, and if the format is unknown
[[nodiscard]] Soup readSoup(std::string_view bytes, std::string_view name, std::size_t sides);

} // namespace qm
