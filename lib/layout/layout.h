/// \file The layout: tracks, and the segments into which they cut the mesh (docs/METHOD.md#layout).
#pragma once

#include "base/ids.h"
#include "layout/motorcycle_graph.h"
#include "mesh/quad_mesh.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace qm {

/// A track of a layout. Transversals split annuli; they are no particles' tracks and do not count in G_T.
struct LayoutTrack {
    Track track;
    bool transversal = false;
};

/// A grid of a x b quads. Counter-clockwise along its border, with the faces on the left, side 0 leads from
/// corner 0 to corner 1 over a edges, side 1 on to corner 2 over b edges, and so on. A side lists its
/// vertices including both corners. Face (i, j), in column i along side 0 and in row j away from it, is
/// faces[j * a + i]. In an annulus split by a transversal, two opposite sides are the same path.
struct Segment {
    std::array<int, 2> size{};
    std::array<VertexId, 4> corners;
    std::array<std::vector<VertexId>, 4> sides;
    std::vector<FaceId> faces;
};

struct Layout {
    double cost = 0; ///< G_T: sum over all tracks except transversals
    std::optional<double> lowerBound;
    std::vector<LayoutTrack> tracks;
    std::vector<Segment> segments; ///< every quad lies in exactly one segment; ordered by lowest face
};

/// The tracks that are not transversals.
[[nodiscard]] std::vector<Track> properTracks(const Layout& layout);

/// Cuts the mesh along the tracks. A component without tracks gets the mesh line through its most curved
/// edge, and every annulus is split by its cheapest straight transversal (docs/METHOD.md#layout); both are
/// added to the tracks. Time is linear in the mesh.
/// \param edgeCosts  by edge index, for the costs of added tracks
/// \throw Error  if some segment is not a grid with four corners, so that the tracks are no motorcycle graph
[[nodiscard]] Layout buildLayout(const QuadMesh& mesh, std::span<const Track> tracks,
                                 const std::vector<double>& dihedralAngles,
                                 const std::vector<double>& edgeCosts);

/// By face: its segment.
[[nodiscard]] std::vector<SegmentId> segmentsOfFaces(const QuadMesh& mesh, const Layout& layout);

/// By vertex: whether a segment has a corner there.
[[nodiscard]] std::vector<bool> cornerMarks(const QuadMesh& mesh, const Layout& layout);

/// The (a + 1) x (b + 1) vertices of a segment, row by row: vertex (i, j) at j * (a + 1) + i.
[[nodiscard]] std::vector<VertexId> vertexGrid(const QuadMesh& mesh, const Segment& segment);

} // namespace qm
