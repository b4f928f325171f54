#include "check/surfaces/spline.h"

#include "base/at.h"
#include "base/positions.h"

#include <algorithm>

namespace qm::check {

namespace {

/// The degree + 1 basis functions that do not vanish at a parameter, from number `first` on.
struct Basis {
    std::size_t first = 0;
    std::size_t count = 1;
    std::array<double, maxDegree + 1> value{1};
    std::array<double, maxDegree + 1> slope{};
};

double share(double part, double whole) {
    return whole > 0 ? part / whole : 0;
}

Basis basisAt(const std::vector<double>& knots, std::size_t degree, double parameter) {
    const std::size_t count = knots.size() - degree - 1;
    const double t = std::clamp(parameter, knots[degree], knots[count]);
    // The last non-empty interval of the domain that begins at or before t.
    const auto after = std::upper_bound(knots.begin() + static_cast<std::ptrdiff_t>(degree) + 1,
                                        knots.begin() + static_cast<std::ptrdiff_t>(count), t);
    std::size_t span = positionIn(knots, after) - 1;
    while (span > degree && knots[span] == knots[span + 1])
        --span;

    // Level d holds the functions span - d ... span of degree d; each mixes two of the level before.
    Basis basis;
    for (std::size_t d = 1; d <= degree; ++d) {
        const auto before = basis.value;
        basis.value.fill(0);
        basis.slope.fill(0);
        for (std::size_t i = 0; i < d; ++i) {
            const double begin = knots[span + i + 1 - d];
            const double end = knots[span + i + 1];
            const double slope = before[i] * share(static_cast<double>(d), end - begin);
            basis.value[i] += before[i] * share(end - t, end - begin);
            basis.value[i + 1] += before[i] * share(t - begin, end - begin);
            basis.slope[i] -= slope;
            basis.slope[i + 1] += slope;
        }
    }
    basis.first = span - degree;
    basis.count = degree + 1;
    return basis;
}

} // namespace

SurfacePoint evaluate(const SurfacesPart::Patch& patch, double u, double v) {
    const Basis across = basisAt(patch.knots[0], at(patch.degree[0]), u);
    const Basis up = basisAt(patch.knots[1], at(patch.degree[1]), v);
    SurfacePoint result;
    for (std::size_t j = 0; j < up.count; ++j) {
        for (std::size_t i = 0; i < across.count; ++i) {
            const auto& control = patch.controlPoints[(up.first + j) * at(patch.count[0]) + across.first + i];
            for (std::size_t k = 0; k < 3; ++k) {
                result.point[k] += up.value[j] * across.value[i] * control[k];
                result.alongU[k] += up.value[j] * across.slope[i] * control[k];
                result.alongV[k] += up.slope[j] * across.value[i] * control[k];
            }
        }
    }
    return result;
}

std::vector<SurfacePoint> evaluateLattice(const SurfacesPart::Patch& patch, const std::vector<double>& us,
                                          const std::vector<double>& vs) {
    const std::size_t columns = at(patch.count[0]);
    std::vector<Basis> across;
    across.reserve(us.size());
    for (const double u : us)
        across.push_back(basisAt(patch.knots[0], at(patch.degree[0]), u));
    // Only these control points matter.
    const std::size_t first = across.front().first;
    const std::size_t wanted = across.back().first + across.back().count - first;
    std::vector<SurfacePoint> points(us.size() * vs.size());
    std::vector<std::array<double, 3>> row;
    std::vector<std::array<double, 3>> slopes;
    auto* result = points.data();
    for (const double v : vs) {
        // Control points of the curve v = const, and of its derivative by v.
        const Basis up = basisAt(patch.knots[1], at(patch.degree[1]), v);
        row.assign(wanted, {});
        slopes.assign(wanted, {});
        for (std::size_t j = 0; j < up.count; ++j)
            for (std::size_t i = 0; i < wanted; ++i)
                for (std::size_t k = 0; k < 3; ++k) {
                    const double coordinate = patch.controlPoints[(up.first + j) * columns + first + i][k];
                    row[i][k] += up.value[j] * coordinate;
                    slopes[i][k] += up.slope[j] * coordinate;
                }
        for (const Basis& basis : across) {
            for (std::size_t i = 0; i < basis.count; ++i)
                for (std::size_t k = 0; k < 3; ++k) {
                    const std::size_t here = basis.first - first + i;
                    result->point[k] += basis.value[i] * row[here][k];
                    result->alongU[k] += basis.slope[i] * row[here][k];
                    result->alongV[k] += basis.value[i] * slopes[here][k];
                }
            ++result;
        }
    }
    return points;
}

} // namespace qm::check
