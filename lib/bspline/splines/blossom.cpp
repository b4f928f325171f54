#include "bspline/splines/blossom.h"

#include "bspline/splines/eigen_point.h"

#include <array>

namespace qm {

BlossomWeights blossomWeights(std::span<const double> knots, std::size_t span,
                              std::span<const double> arguments) {
    const std::size_t count = arguments.size() + 1;
    std::array<BlossomWeights, maxDegree + 1> points;
    for (std::size_t k = 0; k < count; ++k)
        points[k] = BlossomWeights::Unit(eigenIndex(count), eigenIndex(k));
    return blossom(knots, span, arguments, std::span(points).first(count));
}

} // namespace qm
