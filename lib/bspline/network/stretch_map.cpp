#include "bspline/network/stretch_map.h"

#include "base/at.h"

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

PlaceAcross StretchMap::across(const StretchEnd& from, double x) const {
    const Stretch& stretch = network_.stretches[from.stretch];
    const StretchSide& to = stretch.sides[1 - from.which];
    const auto& size = layout_.segments[to.patch].size;
    const std::size_t direction = directionAlong(to.side);
    const double length = stretch.length();
    const auto edge = static_cast<std::size_t>(std::clamp(x, 0.0, length - 1));
    const std::size_t index = at(mesh_.edge_handle(stretch.halfedges[edge]));
    return {to.patch, direction, patchParameter(size, to, x), !network_.marks.isCrease[index]};
}

std::optional<PlaceAcross> StretchMap::across(std::size_t patch, int side, double parameter) const {
    for (const StretchEnd& end : on(patch, side)) {
        const Stretch& stretch = network_.stretches[end.stretch];
        const double x = stretchParameter(layout_.segments[patch].size, stretch.sides[end.which], parameter);
        if (x >= 0 && x <= stretch.length()) return across(end, x);
    }
    return std::nullopt;
}

} // namespace qm
