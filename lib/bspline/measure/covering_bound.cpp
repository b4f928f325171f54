#include "bspline/measure/covering_bound.h"

#include "base/infinity.h"
#include "bspline/measure/foot_frame.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace qm {
namespace {

struct Range {
    double low = infinity;
    double high = -infinity;

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

Extents extentsOf(const BezierPiece& box, const FootFrame& frame, const Foot& foot) {
    Extents result;
    for (const Eigen::Vector3d& point : box.points) {
        const Eigen::Vector3d away = point - foot.position;
        for (std::size_t k = 0; k < 2; ++k)
            result.along[k].include(away.dot(frame.dual[k]));
        result.height.include(away.dot(frame.normal));
    }
    return result;
}

/// A box of one surface, seen along the normal at a foot on the other.
struct SeenBox {
    std::size_t surface; ///< the other
    const Foot& foot;
    FootFrame frame;
    Extents extents;
};

/// A rectangle of the other surface.
struct Rectangle {
    Range height;
    ParameterBox missing{}; ///< by which its sides fall short of lying beyond the box
};

/// \return nothing if it has too many pieces for a useful bound
std::optional<Rectangle> rectangleOver(const SeenBox& box, const ParameterBox& sides, BoxPieces& pieces) {
    const FootFrame& frame = box.frame;
    const auto& extents = box.extents.along;
    Rectangle result;
    auto& missing = result.missing;
    const bool isDone = pieces.visit(box.surface, box.foot.place.patch, sides, [&](const BoxPiece& part) {
        forEachPoint(part.piece, [&](int i, int j, const Eigen::Vector3d& point) {
            const Eigen::Vector3d away = point - box.foot.position;
            result.height.include(away.dot(frame.normal));
            for (std::size_t k = 0; k < 2; ++k) {
                const int position = k == 0 ? i : j;
                const double along = away.dot(frame.dual[k]);
                if (position == 0 && part.isAtEnd[k][0])
                    missing[k][0] = std::max(missing[k][0], along - extents[k].low);
                if (position == part.piece.degree[k] && part.isAtEnd[k][1])
                    missing[k][1] = std::max(missing[k][1], extents[k].high - along);
            }
        });
    });
    return isDone ? std::optional(result) : std::nullopt;
}

/// Share of the box by which the rectangle is larger than it at each side, at first.
constexpr double margin = 0.1;
/// Multiple of what is missing by which a side is moved that does not lie beyond the box.
constexpr double growth = 1.5;
constexpr int attempts = 3;
/// Share of the heights by which sides may still fall short of the box in the end.
constexpr double negligible = 0.1;

} // namespace

double CoveringBound::operator()(const BezierPiece& box, std::size_t surface, const Foot& foot,
                                 double known) {
    const auto frame = footFrame(foot);
    if (!frame) return known;
    const SeenBox seen{surface, foot, *frame, extentsOf(box, *frame, foot)};
    const Extents& own = seen.extents;
    if (own.height.width() >= known) return known;

    ParameterBox sides{};
    for (std::size_t k = 0; k < 2; ++k) {
        const double more = margin * own.along[k].width();
        sides[k] = {foot.place.at[k] + own.along[k].low - more, foot.place.at[k] + own.along[k].high + more};
    }
    for (int attempt = 0; attempt < attempts; ++attempt) {
        const auto covering = rectangleOver(seen, sides, pieces_);
        if (!covering) break;
        const auto& [height, missing] = *covering;
        const double heights = std::max(own.height.high - height.low, height.high - own.height.low);
        if (heights >= known) break;
        // Continued straight on along the tangents, by so much, the surface would cover the box.
        const double beyond =
            std::ranges::max(missing[0]) * foot.du.norm() + std::ranges::max(missing[1]) * foot.dv.norm();
        known = std::min(known, std::hypot(heights, beyond));
        if (beyond <= negligible * heights) break;
        for (std::size_t k = 0; k < 2; ++k) {
            sides[k][0] -= growth * missing[k][0];
            sides[k][1] += growth * missing[k][1];
        }
    }
    return known;
}

} // namespace qm
