/// \file Regions: what the tracks leave connected, and their borders (method 7).
#pragma once

#include "mesh/quad_mesh.h"

#include <vector>

namespace qm {

/// A closed walk along a region's border with the region on its left. corners[k] tells how many of the
/// region's quads lie between halfedge k and the next: 1 is a convex corner, 2 is straight on, more is a
/// reflex corner.
struct BorderLoop {
    std::vector<HalfedgeId> halfedges;
    std::vector<int> quads;

    [[nodiscard]] std::size_t corners() const;
};

/// Faces joined by edges that are neither tracks nor mesh boundary.
struct Region {
    std::vector<FaceId> faces; ///< ascending
    std::vector<BorderLoop> loops;
};

/// The edges that separate regions: tracks and the mesh boundary.
class Borders {
public:
    explicit Borders(const QuadMesh& mesh);

    void add(EdgeId edge) { border_[static_cast<std::size_t>(edge.idx())] = true; }
    [[nodiscard]] bool isBorder(HalfedgeId halfedge) const {
        return border_[static_cast<std::size_t>(halfedge.idx() / 2)];
    }

private:
    std::vector<bool> border_;
};

/// The regions that some faces fall into, ordered by their lowest face.
/// \param faces  ascending; a union of regions
[[nodiscard]] std::vector<Region> findRegions(const QuadMesh& mesh, const Borders& borders,
                                              const std::vector<FaceId>& faces);

} // namespace qm
