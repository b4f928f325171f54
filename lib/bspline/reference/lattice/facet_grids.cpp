#include "bspline/reference/lattice/facet_grids.h"

#include "bspline/splines/interpolate.h"

namespace qm {

std::vector<ReferenceGrid> facetGrids(const QuadMesh& mesh, const Layout& layout) {
    std::vector<ReferenceGrid> grids;
    for (const Segment& segment : layout.segments)
        grids.push_back({segment.size, 1, pointGrid(mesh, segment)});
    return grids;
}

} // namespace qm
