/// \file The effect of removing a track on the segments around it (docs/METHOD.md#pruning).
#pragma once

#include "base/disjoint_sets.h"
#include "base/ids.h"
#include "layout/borders.h"
#include "layout/layout.h"

#include <array>
#include <vector>

namespace qm {

/// Keeps track of which edges are borders and which faces belong to one segment while tracks are removed.
/// Borders are the tracks and the mesh boundary, but not transversals, which are drawn anew in the end.
///
/// It is enough to look at the vertices of the track. If afterwards no segment takes more than two quads at
/// any of them, and none of them is an extraordinary vertex inside a segment, then by Gauss-Bonnet every new
/// segment is a disk with four corners, an annulus or a torus. It is a disk exactly if the pieces of the
/// track between crossing borders join segments as the edges of a forest join nodes. Of the tracks beside an
/// annulus, only a closed one that no other border touches passes the test at its vertices: at the end of any
/// other, the annulus takes two quads, and the other side adds at least one. Such a loop has annuli on both
/// sides. It stays, because without it they would become one annulus or a torus, not a grid with four
/// corners. So annuli and their transversals never change.
class Removal {
public:
    Removal(const QuadMesh& mesh, const Layout& layout);

    /// Whether every segment would stay a grid with four corners. Time is linear in the track's length.
    [[nodiscard]] bool keepsGrids(const Track& track);

    /// The largest turn in degrees, 0 to 180, of the borders that remain where the track ended.
    /// \param track  must pass `keepsGrids`, so that one segment goes straight on at each end
    [[nodiscard]] double largestTurn(const Track& track) const;

    /// Whether every corner keeps its room at the extraordinary vertices where the track ends, see `roomAt`.
    [[nodiscard]] bool leavesRoom(const Track& track, const std::vector<double>& dihedralAngles,
                                  double minCorner) const;

    /// \return the borders next to the track around its vertices; the outcome of `keepsGrids` and
    /// `largestTurn` can have changed only for tracks on these
    std::vector<EdgeId> remove(const Track& track);

private:
    /// The surroundings of an edge at the vertex where a halfedge on it begins: the next borders
    /// counter-clockwise and clockwise, and the quads between the two. Without any border, both are the
    /// halfedge itself, and the quads are counted twice.
    struct Sector {
        HalfedgeId left;
        HalfedgeId right;
        int quads = 0;
    };
    /// Neighbouring segments that a removal joins: one pair for every piece of the track between crossing
    /// borders.
    using Pairs = std::vector<std::array<SegmentId, 2>>;

    [[nodiscard]] Sector sectorAt(HalfedgeId leaving) const;
    [[nodiscard]] bool properAt(HalfedgeId leaving) const;
    [[nodiscard]] bool properAlong(const Track& track) const;
    [[nodiscard]] Pairs joinedPairs(const Track& track);
    [[nodiscard]] bool joinsForest(const Track& track);
    [[nodiscard]] double turnAt(HalfedgeId leaving) const;
    SegmentId find(SegmentId segment);

    const QuadMesh& mesh_;
    Borders borders_;
    std::vector<SegmentId> segmentOf_; ///< of every face, in the original layout
    DisjointSets sets_;                ///< of segments that have been joined
};

} // namespace qm
