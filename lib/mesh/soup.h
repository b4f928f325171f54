/// \file A polygon soup: what a file says, before anything is asked of it.
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

    // For messages, which speak of the file whatever has been done to the soup since.
    std::vector<std::uint32_t> pointLines;   ///< line of each point, from 1; empty for binary files
    std::vector<std::uint32_t> faceLines;    ///< likewise of each polygon
    std::vector<std::uint32_t> pointNumbers; ///< number in the file; empty if that is the position
    std::vector<std::uint32_t> faceNumbers;  ///< likewise of each polygon

    [[nodiscard]] std::size_t faceCount() const { return faceBegins.size() - 1; }
    [[nodiscard]] std::span<const std::int64_t> face(std::size_t k) const {
        return {corners.data() + faceBegins[k], corners.data() + faceBegins[k + 1]};
    }
    /// The corners added since the last polygon are one.
    /// \param line  0 if there are no lines
    void endFace(std::uint32_t line);

    /// The number of a point in the file.
    [[nodiscard]] std::size_t pointNumber(std::size_t k) const;
    /// "vertex 7 (line 12)".
    [[nodiscard]] std::string pointPlace(std::size_t k) const;
    /// "face 7 (line 12)".
    [[nodiscard]] std::string facePlace(std::size_t k) const;
};

/// Relative indices, texture and normal indices, colours, continued lines and any line ends are understood;
/// other statements are passed over.
/// \param sides  a face at the end of the text that has fewer is cut off
/// \throw Error  naming the line, if the text is no OBJ or is cut off
[[nodiscard]] Soup readObj(std::string_view text, std::size_t sides);

/// Colours and normals are passed over, and a face may be spread over lines.
/// \throw Error  naming the line, if the text is no OFF in ASCII or holds less or more than its header says
[[nodiscard]] Soup readOff(std::string_view text);

/// ASCII, or binary of either byte order; what is neither a vertex's place nor a face's corners is passed
/// over.
/// \throw Error  if the bytes are no PLY or hold less or more than their header says
[[nodiscard]] Soup readPly(std::string_view bytes);

/// Text or binary. Every facet has points of its own.
/// \throw Error  if the bytes are no STL or hold less or more than they announce
[[nodiscard]] Soup readStl(std::string_view bytes);

/// Any of these.
/// \param name  of the file; its extension tells the format, and where it has none the first word does
/// \param sides  of the faces that are wanted
/// \throw Error  as above, and if the format is not known
[[nodiscard]] Soup readSoup(std::string_view bytes, std::string_view name, std::size_t sides);

} // namespace qm
