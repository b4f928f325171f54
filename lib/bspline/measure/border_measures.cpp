#include "bspline/measure/border_measures.h"

#include "base/at.h"
#include "base/infinity.h"
#include "bspline/splines/bezier_extraction.h"
#include "mesh/angle_between.h"

#include <algorithm>
#include <cmath>

namespace qm {
namespace {

constexpr double nearEnd = 1.0 / 200; ///< of an edge: far enough from where a patch may have no normal

void add(const SurfacePoint& a, const SurfacePoint& b, MeetingMeasures& measures) {
    measures.gap = std::max(measures.gap, (a.position - b.position).norm());
    const auto normal = unitNormal(a.du, a.dv), other = unitNormal(b.du, b.dv);
    measures.angles.push_back(normal && other ? degreesBetween(*normal, *other) : 0);
}

} // namespace

SurfacePoint pointAt(const Layout& layout, const std::vector<Patch>& patches, const BorderPlace& place,
                     double along) {
    const auto [u, v] = parametersAt(layout, place, along);
    return evaluate(patches[place.patch], u, v);
}

std::array<SurfacePoint, 2> pointsOnBothSides(const Layout& layout, const std::vector<Patch>& patches,
                                              const BorderEdge& border, double along) {
    return {pointAt(layout, patches, border.places[0], along),
            pointAt(layout, patches, border.places[1], 1 - along)};
}

MeetingMeasures measureBorder(const BorderEdge& border, const Layout& layout,
                              const std::vector<Patch>& patches, int samples) {
    MeetingMeasures measures;
    if (border.places.size() != 2) return measures;
    const auto meeting = [&](double along) { return pointsOnBothSides(layout, patches, border, along); };
    measures.angles.reserve(at(samples));
    for (int k = 0; k < samples; ++k) {
        const double along = static_cast<double>(k) / (samples - 1);
        const auto points = meeting(std::clamp(along, nearEnd, 1 - nearEnd));
        add(points[0], points[1], measures);
    }
    for (const double end : {0.0, 1.0}) {
        const auto points = meeting(end);
        measures.gap = std::max(measures.gap, (points[0].position - points[1].position).norm());
    }
    return measures;
}

MeetingMeasures measureInnerLines(const Patch& patch, int samples) {
    MeetingMeasures measures;
    for (std::size_t k = 0; k < 2; ++k) {
        const auto& knots = patch.knots[k];
        const auto [begin, end] = domain(patch.knots[1 - k], patch.degree[1 - k]);
        const int steps = std::max(1, static_cast<int>(std::lround((end - begin) * samples)));
        const auto different = differentKnots(knots, patch.degree[k]);
        for (std::size_t line = 1; line + 1 < different.size(); ++line) {
            const double after = different[line];
            if (std::ranges::count(knots, after) < patch.degree[k]) continue;
            const double before = std::nextafter(after, -infinity);
            for (int step = 0; step <= steps; ++step) {
                const double along = std::lerp(begin, end, static_cast<double>(step) / steps);
                const auto at = [&](double across) {
                    return k == 0 ? evaluate(patch, across, along) : evaluate(patch, along, across);
                };
                add(at(before), at(after), measures);
            }
        }
    }
    return measures;
}

} // namespace qm
