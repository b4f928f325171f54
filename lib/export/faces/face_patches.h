/// \file The faces of a solid before export: the patches of a layout, parts of them, or several as one; with
/// the sources join, separate and quarter_turn.
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

// ---- join.cpp

/// Repeatedly joins faces that share a full side, with the same knots along it and continuous derivatives
/// across it. No resulting face touches itself. The joint gets as few knots as its smoothness allows.
/// \param tolerance  largest distance by which points of the surfaces may move
[[nodiscard]] FacePatches joined(FacePatches faces, double tolerance);

// ---- separate.cpp

/// Cuts faces along grid lines where a surface is only continuous (an inner knot with a multiplicity equal to
/// the degree), and between the places where a face touches itself, so that a face has every vertex once and
/// no edge twice. Offsets and Boolean operations need the first, meshers the second. A side of hundreds of
/// edges is also cut at T-joints. Everything else stays as it is, except that superfluous knots are removed;
/// parts replace their face, row by row. Linear in the mesh.
/// \param tolerance  largest distance by which points may move where knots are removed
[[nodiscard]] FacePatches separated(const QuadMesh& mesh, FacePatches faces, double tolerance);

/// Whether a vertex is on the segment's border twice.
[[nodiscard]] bool touchesItself(const Segment& segment);

// ---- quarter_turn.cpp

/// Seen so that side 1 is side 0.
[[nodiscard]] Segment quarterTurned(const Segment& segment);
[[nodiscard]] Patch quarterTurned(const Patch& patch);

/// Turns faces that have more knots along u than along v. OpenCASCADE computes volumes with as many points in
/// both directions as suit the knots along v: where those along u were many more, volumes were wrong by up to
/// a fifth.
[[nodiscard]] FacePatches withMoreKnotsAlongV(FacePatches faces);

} // namespace qm
