#include "bspline/network/stretch_map.h"

#include "base/at.h"
#include "layout/sides.h"

#include <algorithm>

namespace qm {

StretchMap::StretchMap(const QuadMesh& mesh, const Layout& layout, const SmoothNetwork& network)
    : mesh_(mesh), layout_(layout), network_(network), sides_(layout.segments.size()) {
    for (std::size_t k = 0; k < network.stretches.size(); ++k)
        for (std::size_t which = 0; which < 2; ++which) {
            const StretchSide& place = network.stretches[k].sides[which];
            sides_[place.patch][at(place.side)].push_back({k, which});
        }
}

std::optional<PlaceAcross> StretchMap::across(std::size_t patch, int side, double parameter) const {
    for (const StretchEnd& end : on(patch, side)) {
        const Stretch& stretch = network_.stretches[end.stretch];
        const double x = stretchParameter(layout_.segments[patch].size, stretch.sides[end.which], parameter);
        if (x < 0 || x > stretch.length()) continue;
        const StretchSide& to = stretch.sides[1 - end.which];
        const auto edge = static_cast<std::size_t>(std::min(x, stretch.length() - 1.0));
        const bool isCrease = network_.marks.isCrease[at(mesh_.edge_handle(stretch.halfedges[edge]))];
        return PlaceAcross{to.patch, directionAlong(to.side),
                           patchParameter(layout_.segments[to.patch].size, to, x), !isCrease};
    }
    return std::nullopt;
}

} // namespace qm
