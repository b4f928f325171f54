#include "bspline/measure/distance_bound.h"

#include "base/at.h"
#include "base/infinity.h"
#include "bspline/measure/foot_frame.h"
#include "bspline/measure/quarter_turns.h"

#include <algorithm>
#include <cmath>

namespace qm {
namespace {

/// How much faster the own surface runs than the other along its direction.
double speedRatio(const Eigen::Vector3d& own, const Eigen::Vector3d& other) {
    const double square = other.squaredNorm();
    return square > 0 ? std::clamp(own.dot(other) / square, 0.5, 2.0) : 1;
}

/// Where to divide a box, from -1/2 to 1/2.
/// \param low, high  ends of the other's cell, the box being from -1 to 1
double division(double low, double high) {
    constexpr double thin = 0.9; // a part beyond it would be a sliver
    const double nearer = std::abs(low) < std::abs(high) ? low : high;
    return std::abs(nearer) < thin ? nearer / 2 : 0;
}

/// The own surface minus the other, by the other's parameters.
/// \param difference  the other surface, written over
void subtractFrom(const BezierPiece& own, int turns, BezierPiece& difference) {
    const int degree = own.degree[0];
    forEachPoint(own, [&](int i, int j, const Eigen::Vector3d& point) {
        const auto [column, row] = turnedIndex({i, j}, degree, turns);
        Eigen::Vector3d& here = difference.points[at(row) * (at(degree) + 1) + at(column)];
        here = point - here;
    });
}

} // namespace

LayoutPlace DistanceBound::middle(const SurfacePart& part) const {
    LayoutPlace place{part.cell.patch, {}};
    const ParameterBox cell = surfaces_.box(part.cell);
    for (std::size_t k = 0; k < 2; ++k)
        place.at[k] = std::lerp(cell[k][0], cell[k][1], 0.5 * (part.from[k] + part.to[k]));
    return place;
}

double DistanceBound::tangentVariation(std::size_t surface, const Foot& foot, const ParameterBox& touched) {
    Parameters variation{}; // squared
    const bool isDone = pieces_.visit(surface, foot.place.patch, touched, [&](const BoxPiece& part) {
        const int degree = part.piece.degree[0];
        forEachPoint(part.piece, [&](int i, int j, const Eigen::Vector3d& point) {
            const auto farther = [&](std::size_t k, const Eigen::Vector3d& next,
                                     const Eigen::Vector3d& tangent) {
                const Eigen::Vector3d slope = degree / part.width[k] * (next - point);
                variation[k] = std::max(variation[k], (slope - tangent).squaredNorm());
            };
            if (i < degree) farther(0, part.piece.at(i + 1, j), foot.du);
            if (j < degree) farther(1, part.piece.at(i, j + 1), foot.dv);
        });
    });
    return isDone ? std::sqrt(variation[0] + variation[1]) : infinity;
}

double DistanceBound::slidingBound(std::size_t surface, const Foot& foot, const ParameterBox& box,
                                   double known) {
    const auto frame = footFrame(foot);
    if (!frame) return infinity;
    double height = 0;
    double slide = 0;
    ParameterBox touched = box;
    const int degree = difference_.degree[0];
    forEachPoint(difference_, [&](int i, int j, const Eigen::Vector3d& point) {
        height = std::max(height, std::abs(point.dot(frame->normal)));
        const Parameters along{point.dot(frame->dual[0]), point.dot(frame->dual[1])};
        slide = std::max(slide, std::hypot(along[0], along[1]));
        for (std::size_t k = 0; k < 2; ++k) {
            const double share = static_cast<double>(k == 0 ? i : j) / degree;
            const double to = std::lerp(box[k][0], box[k][1], share) + along[k];
            touched[k] = {std::min(touched[k][0], to), std::max(touched[k][1], to)};
        }
    });
    // Slides end at the patch's border.
    double cutOff = 0;
    const Parameters extent = surfaces_.extent(foot.place.patch);
    for (std::size_t k = 0; k < 2; ++k) {
        const double beyond = std::max({0.0, -touched[k][0], touched[k][1] - extent[k]});
        cutOff += beyond * (k == 0 ? foot.du : foot.dv).norm();
        touched[k] = {std::max(touched[k][0], 0.0), std::min(touched[k][1], extent[k])};
    }
    const double remaining = std::hypot(height, cutOff);
    if (!(remaining < known)) return known;
    return remaining + slide * tangentVariation(surface, foot, touched);
}

DistanceBound::BoxMiddle DistanceBound::takeOwn(const SurfacePart& part) {
    restrict(ownCell_(part.surface, part.cell), part.from, part.to, own_);
    BoxMiddle result{evaluate(own_, 0.5, 0.5), {}};
    const ParameterBox cell = surfaces_.box(part.cell);
    for (std::size_t k = 0; k < 2; ++k)
        result.half[k] = 0.5 * (cell[k][1] - cell[k][0]) * (part.to[k] - part.from[k]);
    result.here.du /= 2 * result.half[0];
    result.here.dv /= 2 * result.half[1];
    return result;
}

void DistanceBound::findFoot(const Eigen::Vector3d& ofMiddle, double surprising, SurfacePart& part) {
    const int before = part.foot.turns;
    part.foot = search_(1 - part.surface, part.foot.place, ofMiddle);
    part.foot.turns = (part.foot.turns + before) % 4;
    if (!(part.foot.distance > surprising)) return;
    const Foot other = search_(1 - part.surface, middle(part), ofMiddle);
    if (other.distance < part.foot.distance) part.foot = other;
}

ParameterBox DistanceBound::pairWithOther(const BoxMiddle& own, SurfacePart& part) {
    const Foot& foot = part.foot;
    const Cell target = surfaces_.cellAt(foot.place);
    const ParameterBox cell = surfaces_.box(target);
    ParameterBox box{};
    Parameters begin{};
    Parameters end{};
    for (std::size_t k = 0; k < 2; ++k) {
        const auto [ownAxis, sign] = turnedDirection(k, (4 - foot.turns) % 4);
        const double reach = own.half[ownAxis] * speedRatio(sign * (ownAxis == 0 ? own.here.du : own.here.dv),
                                                            k == 0 ? foot.du : foot.dv);
        const auto [from, to] = cell[k];
        const double at = foot.place.at[k];
        // What reaches beyond the other's cell is squeezed into it.
        begin[k] = std::clamp((at - reach - from) / (to - from), 0.0, 1.0);
        end[k] = std::clamp((at + reach - from) / (to - from), 0.0, 1.0);
        box[k] = {std::lerp(from, to, begin[k]), std::lerp(from, to, end[k])};
        part.division[ownAxis] = std::lerp(part.from[ownAxis], part.to[ownAxis],
                                           0.5 + sign * division((from - at) / reach, (to - at) / reach));
    }
    restrict(otherCell_(1 - part.surface, target), begin, end, difference_);
    subtractFrom(own_, foot.turns, difference_);
    return box;
}

void DistanceBound::tighten(SurfacePart& part, double surprising, double enough) {
    const BoxMiddle own = takeOwn(part);
    findFoot(own.here.position, surprising, part);
    const ParameterBox box = pairWithOther(own, part);
    part.upper = std::min(part.upper, farthestFrom(Eigen::Vector3d::Zero(), difference_));
    if (part.upper <= enough) return;
    part.upper = std::min(part.upper, slidingBound(1 - part.surface, part.foot, box, part.upper));
    if (part.upper <= enough) return;
    part.upper = covering_(own_, 1 - part.surface, part.foot, part.upper);
}

} // namespace qm
