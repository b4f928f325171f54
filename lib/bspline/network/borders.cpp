#include "bspline/network/borders.h"

#include "base/at.h"
#include "layout/sides.h"

namespace qm {

std::array<double, 2> parametersAt(const Layout& layout, const BorderPlace& place, double along) {
    return placeOnSide(layout.segments[place.patch].size, place.side, place.position + along);
}

std::vector<BorderEdge> borderEdges(const QuadMesh& mesh, const Layout& layout) {
    std::vector<BorderEdge> borders;
    std::vector<std::ptrdiff_t> ofEdge(mesh.n_edges(), -1);
    for (std::size_t s = 0; s < layout.segments.size(); ++s) {
        for (int side = 0; side < 4; ++side) {
            const auto& vertices = layout.segments[s].sides[at(side)];
            for (std::size_t k = 0; k + 1 < vertices.size(); ++k) {
                const int position = static_cast<int>(k);
                const HalfedgeId halfedge = mesh.find_halfedge(vertices[k], vertices[k + 1]);
                auto& index = ofEdge[at(mesh.edge_handle(halfedge))];
                if (index < 0) {
                    index = static_cast<std::ptrdiff_t>(borders.size());
                    borders.push_back({halfedge, {}});
                }
                borders[at(index)].places.push_back({s, side, position});
            }
        }
    }
    return borders;
}

} // namespace qm
