#include "bspline/ranking.h"

#include <tuple>

namespace qm {

RankedLayout rankedLayout(const Layout& layout, const Surfaces& surfaces, bool keeps) {
    return {layout.segments.size(), layout.cost, controlPointCount(surfaces.patches),
            surfaces.deviation.maxRelative, keeps};
}

bool ranksBefore(const RankedLayout& a, const RankedLayout& b) {
    if (a.keeps != b.keeps) return a.keeps;
    if (!a.keeps && a.maxRelative != b.maxRelative) return a.maxRelative < b.maxRelative;
    return std::tie(a.controlPoints, a.segments, a.cost) < std::tie(b.controlPoints, b.segments, b.cost);
}

} // namespace qm
