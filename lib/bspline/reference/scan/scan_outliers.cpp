#include "bspline/reference/scan/scan_outliers.h"

#include "base/infinity.h"
#include "base/order_statistics.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace qm {
namespace {

/// Standard deviations at which Tukey's biweight ends, as is usual.
constexpr double biweightEnd = 4.685;

/// The median around a point of a grid, up to so many grains away.
/// \param valueAt  (i, j) the value of a point of the grid, or none
template <class ValueAt>
double medianAround(const ScanTargets& targets, int i, int j, int reach, const ValueAt& valueAt) {
    const int grain = targets.stepsOfGrain();
    std::vector<double> values;
    values.reserve(at((2 * reach + 1) * (2 * reach + 1)));
    for (int down = -reach; down <= reach; ++down)
        for (int right = -reach; right <= reach; ++right)
            if (const auto value = valueAt(i + grain * right, j + grain * down)) values.push_back(*value);
    return median(values);
}

/// How far every point is from the median of those around it: the smaller value, where it is in two grids;
/// infinite where it has no target.
std::vector<double> residualsOfAll(const ScanTargets& targets, int reach) {
    std::vector<double> residuals(targets.weights.size(), infinity);
    targets.forEachPoint([&](std::size_t g, int i, int j, std::size_t number) {
        const auto offsetAt = [&](int k, int m) { return targets.offset(g, k, m); };
        if (const auto own = offsetAt(i, j))
            residuals[number] =
                std::min(residuals[number], std::abs(*own - medianAround(targets, i, j, reach, offsetAt)));
    });
    return residuals;
}

/// The median of the residuals around every point: what is usual in a rough place is no outlier. The
/// smaller value, where it is in two grids.
std::vector<double> usualResiduals(const ScanTargets& targets, const std::vector<double>& residuals) {
    constexpr int reach = 2;
    std::vector<double> usual(residuals.size(), infinity);
    targets.forEachPoint([&](std::size_t g, int i, int j, std::size_t number) {
        if (targets.weights[number] <= 0) return;
        const auto residualAt = [&](int k, int m) {
            return targets.offset(g, k, m) ? std::optional(residuals[*targets.numberAt(g, k, m)])
                                           : std::nullopt;
        };
        usual[number] = std::min(usual[number], medianAround(targets, i, j, reach, residualAt));
    });
    return usual;
}

} // namespace

double noiseOfTargets(const ScanTargets& targets) {
    std::vector<double> sizes = residualsOfAll(targets, 1);
    std::erase_if(sizes, [](double residual) { return !std::isfinite(residual); });
    return deviationByMedian * median(sizes);
}

void weighOutliers(ScanTargets& targets, double step) {
    const std::vector<double> residuals = residualsOfAll(targets, 2); // spikes are wider than a point
    const std::vector<double> usual = usualResiduals(targets, residuals);
    for (std::size_t k = 0; k < residuals.size(); ++k) {
        const double end = biweightEnd * std::max({targets.noise, deviationByMedian * usual[k], step});
        const double share = residuals[k] / end;
        targets.weights[k] *= share < 1 ? (1 - share * share) * (1 - share * share) : 0;
    }
}

void dropSharpOutliers(ScanTargets& targets, double step) {
    constexpr int reach = 3;
    std::vector<double> residuals(targets.weights.size(), infinity);
    const auto compare = [&](std::size_t g, int i, int j, int right, int down, std::size_t number) {
        std::array<std::vector<double>, 3> around;
        for (int k = -reach; k <= reach; ++k) {
            const auto other = targets.numberAt(g, i + k * right, j + k * down);
            if (!other || !targets.lattice.sharp[*other] || targets.weights[*other] <= 0) continue;
            for (int axis = 0; axis < 3; ++axis)
                around[at(axis)].push_back((*targets.displacements[*other])[axis]);
        }
        const Eigen::Vector3d usual(median(around[0]), median(around[1]), median(around[2]));
        residuals[number] = std::min(residuals[number], (*targets.displacements[number] - usual).norm());
    };
    targets.forEachPoint([&](std::size_t g, int i, int j, std::size_t number) {
        if (!targets.lattice.sharp[number] || targets.weights[number] <= 0) return;
        if (j == 0 || j == targets.rows(g)) compare(g, i, j, 1, 0, number);
        if (i == 0 || i == targets.columns(g)) compare(g, i, j, 0, 1, number);
    });
    for (std::size_t k = 0; k < residuals.size(); ++k)
        if (std::isfinite(residuals[k]) && residuals[k] > biweightEnd * std::max(targets.noise, step))
            targets.weights[k] = 0;
}

} // namespace qm
