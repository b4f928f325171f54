#include "bspline/splines/basis.h"

#include "base/at.h"
#include "base/positions.h"

#include <algorithm>

namespace qm {

int clampedDegree(std::span<const double> knots) {
    return static_cast<int>(std::ranges::count(knots, knots.front())) - 1;
}

std::array<double, 2> domain(std::span<const double> knots, int degree) {
    const std::size_t p = at(degree);
    return {knots[p], knots[knots.size() - p - 1]};
}

std::size_t knotSpan(std::span<const double> knots, int degree, double parameter) {
    const std::size_t p = at(degree);
    const auto begin = knots.begin() + degree;
    const auto end = knots.begin() + static_cast<std::ptrdiff_t>(knots.size() - p - 1);
    // The last knot of the domain ends an interval; it does not begin one.
    const auto after =
        parameter >= *end ? std::lower_bound(begin, end, *end) : std::upper_bound(begin + 1, end, parameter);
    return positionIn(knots, after) - 1;
}

BasisValues basisValues(std::span<const double> knots, int degree, double parameter) {
    const std::size_t p = at(degree);
    const std::size_t span = knotSpan(knots, degree, parameter);
    BasisValues result;
    result.first = span - p;
    auto& value = result.value;
    value[0] = 1;
    std::array<double, maxDegree + 1> lower{}; // the values of one degree less, for the derivatives
    for (std::size_t d = 1; d <= p; ++d) {
        lower = value;
        double carried = 0;
        for (std::size_t r = 0; r < d; ++r) {
            const double left = knots[span + 1 + r - d];
            const double right = knots[span + 1 + r];
            const double share = value[r] / (right - left);
            value[r] = carried + (right - parameter) * share;
            carried = (parameter - left) * share;
        }
        value[d] = carried;
    }
    for (std::size_t r = 0; r <= p && p > 0; ++r) {
        double sum = 0;
        if (r > 0) sum += lower[r - 1] / (knots[span + r] - knots[span + r - p]);
        if (r < p) sum -= lower[r] / (knots[span + r + 1] - knots[span + r + 1 - p]);
        result.derivative[r] = degree * sum;
    }
    return result;
}

std::vector<BasisValues> basisTable(std::span<const double> knots, int degree,
                                    std::span<const double> parameters) {
    std::vector<BasisValues> table;
    table.reserve(parameters.size());
    for (const double parameter : parameters)
        table.push_back(basisValues(knots, degree, parameter));
    return table;
}

} // namespace qm
