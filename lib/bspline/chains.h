/// \file The network of the layout's border edges, as chains along which one curve can run.
#pragma once

#include "bspline/borders.h"
#include "layout/layout.h"

#include <array>
#include <cstddef>
#include <vector>

namespace qm {

/// A maximal run of border edges of which every two successive ones follow each other on a side of some
/// patch, at a regular vertex. So a chain passes T-joints of its own sides and ends on others. One that
/// returns to its beginning is open there all the same, at a patch's corner.
struct BorderChain {
    std::vector<HalfedgeId> halfedges;
    bool closed = false;

    [[nodiscard]] int length() const { return static_cast<int>(halfedges.size()); }
};

/// An edge of a chain walked so that one patch lies on the left: forwards (way 0) or backwards (way 1).
struct ChainPlace {
    std::size_t chain = 0;
    int way = 0;
    int position = 0; ///< number of the edge, counted along the way
};

/// A part of a patch's side that lies on one chain: `length` edges from `place` on.
struct SidePiece {
    ChainPlace place;
    int length = 0;
};

class Chains {
public:
    Chains(const QuadMesh& mesh, const Layout& layout);

    [[nodiscard]] const std::vector<BorderChain>& all() const { return chains_; }
    /// The pieces of each side of each patch, in the side's direction; one, unless the side passes an
    /// extraordinary vertex or the place where a closed chain is open.
    [[nodiscard]] const std::vector<SidePiece>& pieces(std::size_t patch, int side) const {
        return pieces_[patch][static_cast<std::size_t>(side)];
    }
    [[nodiscard]] bool isBorder(EdgeId edge) const {
        return chainOf_[static_cast<std::size_t>(edge.idx())] >= 0;
    }
    /// \param halfedge  of a border edge; the way is the one that has it in its direction
    [[nodiscard]] ChainPlace place(HalfedgeId halfedge) const;
    /// The edge at a position of a chain walked either way, in the direction of the way.
    [[nodiscard]] HalfedgeId halfedge(const ChainPlace& place) const;
    /// True if a patch lies on the left of the chain's edges when walked this way.
    [[nodiscard]] bool hasPatch(std::size_t chain, int way) const;

private:
    void trace(const std::vector<BorderEdge>& borders, const Layout& layout);

    const QuadMesh* mesh_;
    std::vector<BorderChain> chains_;
    std::vector<std::array<std::vector<SidePiece>, 4>> pieces_;
    std::vector<std::ptrdiff_t> chainOf_; ///< by edge index, -1 if the edge is no border
    std::vector<int> positionOf_;         ///< by edge index, counted forwards
};

} // namespace qm
