/// \file The faces of a solid before export: the patches of a layout, or parts of them.
#pragma once

#include "bspline/splines/surfaces.h"
#include "layout/layout.h"

#include <cstddef>
#include <vector>

namespace qm {

/// By face: the segments of the given layout that it consists of, ascending.
using FaceOrigins = std::vector<std::vector<std::size_t>>;

/// Faces instead of segments: each a grid of quads and its surface, clamped, over [0, a] x [0, b].
struct FacePatches {
    Layout layout; ///< one segment per face; no tracks
    std::vector<Patch> patches;
    FaceOrigins origins;

    void add(Segment segment, Patch patch, std::vector<std::size_t> segments);
};

/// Makes one face of every segment.
/// \throw Error  if patches are not of degrees 1 to 3, have inner knots with a degree below 3, are not
/// continuous, or do not belong to the layout
[[nodiscard]] FacePatches facePatches(const Layout& layout, const std::vector<Patch>& patches);

/// The quads of columns [from[0], to[0]) and rows [from[1], to[1]) of a segment.
/// \param vertices  as given by `vertexGrid`
[[nodiscard]] Segment partOf(const std::vector<VertexId>& vertices, const Segment& segment,
                             const std::array<int, 2>& from, const std::array<int, 2>& to);

/// The same part of its patch, over a domain that starts at 0.
[[nodiscard]] Patch partOf(const Patch& clampedPatch, const std::array<int, 2>& from,
                           const std::array<int, 2>& to);

} // namespace qm
