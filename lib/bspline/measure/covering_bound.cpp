#include "bspline/measure/covering_bound.h"

#include "bspline/measure/foot_frame.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace qm {
namespace {

struct Range {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    void include(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
    [[nodiscard]] double width() const { return high - low; }
};

/// What a surface has along the tangents at a foot, in parameters, and above the plane that they span.
struct Extents {
    std::array<Range, 2> along;
    Range height;
};

Extents extentsOf(const BezierPiece& box, const FootFrame& frame, const Eigen::Vector3d& origin) {
    Extents result;
    for (const Eigen::Vector3d& point : box.points) {
        const Eigen::Vector3d away = point - origin;
        for (std::size_t k = 0; k < 2; ++k)
            result.along[k].include(away.dot(frame.dual[k]));
        result.height.include(away.dot(frame.normal));
    }
    return result;
}

/// At first the rectangle is larger than the box by this share of it at each side.
constexpr double margin = 0.1;
/// The rectangle grows where its sides do not lie beyond the box, by so much more than they fall short of it.
constexpr double growth = 1.5;
constexpr int attempts = 3;
/// What they may fall short of in the end, as a share of the heights.
constexpr double negligible = 0.1;

} // namespace

Eigen::Vector3d CoveringBound::pointAt(std::size_t surface, const LayoutPlace& place) {
    const Cell cell = surfaces_.cellAt(place);
    std::array<double, 2> within{};
    for (std::size_t k = 0; k < 2; ++k) {
        const auto [from, to] = surfaces_.range(cell, k);
        within[k] = (place.at[k] - from) / (to - from);
    }
    surfaces_.get(surface, cell, cell_);
    return evaluate(cell_, within[0], within[1]).position;
}

double CoveringBound::operator()(const BezierPiece& box, std::size_t surface, const Foot& foot,
                                 double known) {
    const auto frame = footFrame(foot);
    if (!frame) return known;
    const Eigen::Vector3d origin = pointAt(surface, foot.place);
    const Extents own = extentsOf(box, *frame, origin);
    if (own.height.width() >= known) return known;

    ParameterBox covering{};
    for (std::size_t k = 0; k < 2; ++k) {
        const double more = margin * own.along[k].width();
        covering[k] = {foot.place.at[k] + own.along[k].low - more,
                       foot.place.at[k] + own.along[k].high + more};
    }
    const auto extent = surfaces_.extent(foot.place.patch);
    for (int attempt = 0; attempt < attempts; ++attempt) {
        for (std::size_t k = 0; k < 2; ++k)
            for (double& end : covering[k])
                end = std::clamp(end, 0.0, extent[k]);
        Range height;
        ParameterBox missing{}; // by which the sides fall short of lying beyond the box
        const bool isDone = pieces_.visit(surface, foot.place.patch, covering, [&](const BoxPiece& part) {
            const int degree = part.piece.degree[0];
            for (int j = 0; j <= degree; ++j)
                for (int i = 0; i <= degree; ++i) {
                    const Eigen::Vector3d away = part.piece.at(i, j) - origin;
                    height.include(away.dot(frame->normal));
                    for (std::size_t k = 0; k < 2; ++k) {
                        const int position = k == 0 ? i : j;
                        const double along = away.dot(frame->dual[k]);
                        if (position == 0 && part.isAtEnd[k][0])
                            missing[k][0] = std::max(missing[k][0], along - own.along[k].low);
                        if (position == degree && part.isAtEnd[k][1])
                            missing[k][1] = std::max(missing[k][1], own.along[k].high - along);
                    }
                }
        });
        if (!isDone) break;
        const double heights = std::max(own.height.high - height.low, height.high - own.height.low);
        if (heights >= known) break;
        // Continued straight on along the tangents, by so much, the surface would cover the box.
        const double beyond =
            std::ranges::max(missing[0]) * foot.du.norm() + std::ranges::max(missing[1]) * foot.dv.norm();
        known = std::min(known, std::hypot(heights, beyond));
        if (beyond <= negligible * heights) break;
        for (std::size_t k = 0; k < 2; ++k) {
            covering[k][0] -= growth * missing[k][0];
            covering[k][1] += growth * missing[k][1];
        }
    }
    return known;
}

} // namespace qm
