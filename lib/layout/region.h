/// \file Regions: faces that tracks leave connected, and their borders (docs/METHOD.md#layout).
#pragma once

#include "layout/borders.h"
#include "mesh/quad_mesh.h"

#include <vector>

namespace qm {

/// A closed walk along a region's border with the region on its left. quads[k] is the number of the region's
/// quads between halfedge k and the next one: 1 at a convex corner, 2 where the border goes straight on, more
/// at a reflex corner.
struct BorderLoop {
    std::vector<HalfedgeId> halfedges;
    std::vector<int> quads;

    [[nodiscard]] std::size_t corners() const;
};

/// Faces joined by edges that are neither tracks nor mesh boundary. A region may lie on both sides of an
/// edge, and may come to a vertex several times.
struct Region {
    std::vector<FaceId> faces; ///< ascending
    std::vector<BorderLoop> loops;
};

/// Finds regions. Marks are kept from one search to the next, so that a search takes time linear in the faces
/// it is given, whatever the size of the mesh.
class RegionFinder {
public:
    RegionFinder(const QuadMesh& mesh, const Borders& borders);

    /// The regions that a set of faces consists of, ordered by their lowest face.
    /// \param faces  ascending; a union of regions
    [[nodiscard]] std::vector<Region> find(const std::vector<FaceId>& faces);

private:
    [[nodiscard]] std::vector<FaceId> flood(FaceId start);
    [[nodiscard]] BorderLoop walkLoop(HalfedgeId start);

    const QuadMesh& mesh_;
    const Borders& borders_;
    std::vector<bool> seen_;   ///< faces; all false between searches
    std::vector<bool> walked_; ///< halfedges, likewise
};

} // namespace qm
