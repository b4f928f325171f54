/// \file What becomes of the segments when a track is taken away (method 8).
#pragma once

#include "merge/layout.h"

#include <vector>

namespace qm {

/// Knows which edges are borders and which faces are in one segment, and keeps that up to date as tracks go.
///
/// If after a removal no border turns by more than two quads at any vertex of the track, and no extraordinary
/// vertex lies inside a segment, then by Gauss-Bonnet every new segment is a grid with four corners, an
/// annulus or a torus. The latter two arise only where segments that hang together already are joined once
/// more.
class Removal {
public:
    Removal(const QuadMesh& mesh, const Layout& layout);

    /// Whether every segment stays a grid with four corners. Takes time linear in the track's length.
    [[nodiscard]] bool keepsGrids(const Track& track);

    /// Largest angle by which the border turns, in degrees, where the track ended; 0 where none passes.
    [[nodiscard]] double largestTurn(const Track& track) const;

    void remove(const Track& track);

private:
    /// Neighbouring segments that a removal joins, one pair for every piece between crossing borders.
    using Pairs = std::vector<std::array<int, 2>>;

    [[nodiscard]] bool isBorder(HalfedgeId halfedge) const;
    void setBorder(const Track& track, bool border);
    [[nodiscard]] bool properAround(VertexId vertex) const;
    [[nodiscard]] bool hasBorder(VertexId vertex) const;
    [[nodiscard]] Pairs joinedPairs(const Track& track);
    [[nodiscard]] double turnAt(HalfedgeId leaving) const;
    int find(int segment);

    const QuadMesh& mesh_;
    std::vector<bool> border_;   ///< of every edge
    std::vector<int> segmentOf_; ///< of every face, as the layout has it
    std::vector<int> parent_;    ///< of every segment: what it has been joined to
};

} // namespace qm
