#include "bspline/deviation_samples.h"

#include <algorithm>
#include <cmath>

namespace qm {
namespace {

double rootMeanSquare(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values)
        sum += value * value;
    return values.empty() ? 0 : std::sqrt(sum / static_cast<double>(values.size()));
}

double largest(const std::vector<double>& values) {
    return values.empty() ? 0 : *std::max_element(values.begin(), values.end());
}

/// The smallest value that at least 95 of 100 do not exceed.
double percentile95(std::vector<double> values) {
    if (values.empty()) return 0;
    const std::size_t rank = (values.size() * 19 + 19) / 20 - 1;
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(rank), values.end());
    return values[rank];
}

/// The middle of every edge.
std::vector<double> centreParameters(int edges) {
    std::vector<double> parameters;
    parameters.reserve(static_cast<std::size_t>(edges));
    for (int k = 0; k < edges; ++k)
        parameters.push_back(k + 0.5);
    return parameters;
}

} // namespace

Deviation summary(const DeviationSamples& samples, double diagonal) {
    Deviation result;
    result.max = largest(samples.distances);
    result.rms = rootMeanSquare(samples.distances);
    result.percentile95 = percentile95(samples.distances);
    result.largestGap = samples.gap;
    if (diagonal > 0) {
        result.maxRelative = result.max / diagonal;
        result.rmsRelative = result.rms / diagonal;
        result.percentile95Relative = result.percentile95 / diagonal;
        result.largestGapRelative = result.largestGap / diagonal;
    }
    result.largestKink = largest(samples.kinks);
    result.rmsKink = rootMeanSquare(samples.kinks);
    result.largestNormalDeviation = samples.normalDeviation;
    return result;
}

std::vector<double> latticeParameters(int edges, int steps) {
    std::vector<double> parameters;
    for (int k = 0; k <= edges * steps; ++k)
        parameters.push_back(static_cast<double>(k) / steps);
    return parameters;
}

std::vector<double> normalDeviations(const Patch& patch, const QuadGrid& quads) {
    const auto& size = quads.size();
    const auto points = evaluateLattice(patch, centreParameters(size[0]), centreParameters(size[1]));
    std::vector<double> angles;
    angles.reserve(points.size());
    for (int j = 0; j < size[1]; ++j)
        for (int i = 0; i < size[0]; ++i) {
            const SurfacePoint& on = points[angles.size()];
            angles.push_back(angleInDegrees(unitNormal(on.du, on.dv), quads.normalAtCentre(i, j)));
        }
    return angles;
}

std::array<double, 2> parametersAt(const BorderEdge& border, std::size_t side, const Layout& layout,
                                   double along) {
    const BorderPlace& place = border.places[side];
    return parametersOnSide(layout.segments[place.patch].size, place.side,
                            place.position + (side == 0 ? along : 1 - along));
}

std::array<SurfacePoint, 2> meeting(const BorderEdge& border, const Layout& layout,
                                    const std::vector<Patch>& patches, double along) {
    std::array<SurfacePoint, 2> points;
    for (std::size_t side = 0; side < 2; ++side) {
        const auto [u, v] = parametersAt(border, side, layout, along);
        points[side] = evaluate(patches[border.places[side].patch], u, v);
    }
    return points;
}

double kink(const std::array<SurfacePoint, 2>& points) {
    return angleInDegrees(unitNormal(points[0].du, points[0].dv), unitNormal(points[1].du, points[1].dv));
}

} // namespace qm
