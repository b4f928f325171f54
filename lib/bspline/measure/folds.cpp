#include "bspline/measure/folds.h"

#include "base/at.h"
#include "base/infinity.h"
#include "bspline/reference/lattice/bilinear_quad.h"
#include "bspline/splines/eigen_point.h"
#include "bspline/splines/patch_bezier.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace qm {
namespace {

constexpr int maxHalvings = 5; ///< to 1/32 of a piece

/// The mesh's quad around a place.
BilinearQuad quadAt(const ReferenceGrid& reference, const Parameters& place) {
    const auto along = [&](std::size_t direction) {
        return std::clamp(static_cast<int>(place[direction]), 0, reference.size[direction] - 1);
    };
    return quadBelow(reference, along(0), along(1));
}

/// \param normal  of the patch, over a box around a place
bool isTowards(const ReferenceGrid& reference, const BezierPiece& normal, const Parameters& middle) {
    const SurfacePoint there = reference.evaluate(middle[0], middle[1]);
    Eigen::Vector3d direction = vector(there.du).cross(vector(there.dv));
    // Where the reference has no normal, the mean of the patch's own, which is that of the points.
    if (!(direction.squaredNorm() > 1e-12 * there.du.sqrnorm() * there.dv.sqrnorm()))
        direction = std::accumulate(normal.points.begin(), normal.points.end(),
                                    Eigen::Vector3d(Eigen::Vector3d::Zero()));
    // Over a quad that does not fold itself, a reference that is turned over has overshot.
    const BilinearQuad quad = quadAt(reference, middle);
    if (quad.minCosine() > 0 && direction.dot(vector(quad.normal())) < 0) direction = vector(quad.normal());
    double highest = 0;
    double lowest = infinity;
    for (const Eigen::Vector3d& point : normal.points) {
        highest = std::max(highest, point.dot(direction));
        lowest = std::min(lowest, point.dot(direction));
    }
    constexpr double rounding = 1e-10; // of products of degree 11
    return lowest > rounding * highest;
}

/// A place of a piece that is not certain to be free of folds.
std::optional<Parameters> fold(const ReferenceGrid& reference, const PatchPiece& part, int halvings = 0) {
    const Parameters middle = middleOf(part.box);
    if (isTowards(reference, normalPiece(part.piece), middle)) return std::nullopt;
    if (halvings == maxHalvings) return middle;
    for (const PatchPiece& quarter : quarters(part))
        if (const auto place = fold(reference, quarter, halvings + 1)) return place;
    return std::nullopt;
}

} // namespace

std::vector<Parameters> findFolds(const Patch& patch, const ReferenceGrid& reference) {
    std::vector<Parameters> places;
    forEachPiece(bezierPieces(patch), [&](const PatchPiece& part) {
        if (const auto place = fold(reference, part)) places.push_back(*place);
    });
    return places;
}

} // namespace qm
