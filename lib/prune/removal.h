/// \file What becomes of the segments when a track is taken away (docs/METHOD.md#pruning).
#pragma once

#include "base/disjoint_sets.h"
#include "layout/layout.h"

#include <array>
#include <vector>

namespace qm {

/// Knows which edges are borders and which faces are in one segment, and keeps that up to date while tracks
/// are removed. Borders are the tracks and the mesh boundary, but not transversals: these are drawn anew when
/// the tracks are settled.
///
/// Why looking at the track's own vertices is enough: if afterwards no segment takes more than two quads at
/// any of them, and none of them is an extraordinary vertex inside a segment, then by Gauss-Bonnet every new
/// segment is a disk with four corners, an annulus or a torus. A disk it is exactly if the pieces of the
/// track, between crossing borders, join segments as the edges of a forest join nodes. Of tracks beside an
/// annulus only a closed one that nothing else touches passes the test at the vertices: elsewhere the annulus
/// takes two quads at the track's end, and the other side adds at least one. Such a loop stays, so annuli and
/// their transversals never change.
class Removal {
public:
    Removal(const QuadMesh& mesh, const Layout& layout);

    /// Whether every segment stays a grid with four corners. Takes time linear in the track's length.
    [[nodiscard]] bool keepsGrids(const Track& track);

    /// Largest angle in degrees, 0 to 180, by which the border turns that is left where the track ended.
    /// \param track  with `keepsGrids`: at each end exactly one segment goes straight on
    [[nodiscard]] double largestTurn(const Track& track) const;

    /// Whether every corner at the extraordinary vertices where it ends keeps so many degrees, see `roomAt`.
    [[nodiscard]] bool leavesRoom(const Track& track, const std::vector<double>& dihedralAngles,
                                  double minCorner) const;

    /// \return the borders next to it, around its vertices: only for the tracks there can `keepsGrids` or
    /// `largestTurn` have improved
    std::vector<EdgeId> remove(const Track& track);

private:
    /// What lies on both sides of an edge, at the vertex where a halfedge on it begins: the next border
    /// counter-clockwise and clockwise, and the quads between the two. Without any border both are the
    /// halfedge itself, and the quads are counted twice.
    struct Sector {
        HalfedgeId left;
        HalfedgeId right;
        int quads = 0;
    };
    /// Neighbouring segments that a removal joins, one pair for every piece between crossing borders.
    using Pairs = std::vector<std::array<int, 2>>;

    [[nodiscard]] bool isBorder(HalfedgeId halfedge) const;
    void setBorder(const Track& track, bool border);
    [[nodiscard]] bool hasBorder(VertexId vertex) const;
    [[nodiscard]] Sector sectorAt(HalfedgeId leaving) const;
    [[nodiscard]] bool properAt(HalfedgeId leaving) const;
    [[nodiscard]] bool properAlong(const Track& track) const;
    [[nodiscard]] Pairs joinedPairs(const Track& track);
    [[nodiscard]] bool joinsForest(const Track& track);
    [[nodiscard]] double turnAt(HalfedgeId leaving) const;
    int find(int segment);

    const QuadMesh& mesh_;
    std::vector<bool> border_;   ///< of every edge
    std::vector<int> segmentOf_; ///< of every face, as the layout has it
    DisjointSets sets_;          ///< segments that have been joined
};

} // namespace qm
