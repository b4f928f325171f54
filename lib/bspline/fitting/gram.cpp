#include "bspline/fitting/gram.h"

#include "bspline/splines/basis.h"

#include <cstddef>

namespace qm {
namespace {

struct GaussPoint {
    double at; ///< from -1 to 1
    double weight;
};

/// Exact up to degree 7; a product of two cubics has 6.
constexpr std::array<GaussPoint, 4> gauss = {
    GaussPoint{-0.8611363115940526, 0.3478548451374538}, GaussPoint{-0.3399810435848563, 0.6521451548625461},
    GaussPoint{0.3399810435848563, 0.6521451548625461}, GaussPoint{0.8611363115940526, 0.3478548451374538}};

/// Values, first and second derivatives of the four B-splines at a parameter inside a knot interval.
std::array<std::array<double, 4>, 3> jets(std::span<const double> knots, double at, double step) {
    const BasisValues middle = basisValues(knots, 3, at);
    const BasisValues before = basisValues(knots, 3, at - step);
    const BasisValues after = basisValues(knots, 3, at + step);
    std::array<std::array<double, 4>, 3> result{};
    for (std::size_t k = 0; k < 4; ++k) {
        result[0][k] = middle.value[k];
        result[1][k] = middle.derivative[k];
        // Exact, since first derivatives are quadratic there.
        result[2][k] = (after.derivative[k] - before.derivative[k]) / (2 * step);
    }
    return result;
}

} // namespace

std::array<BandMatrix, 3> gramMatrices(std::span<const double> knots) {
    const std::size_t count = knots.size() - 4;
    std::array<BandMatrix, 3> result;
    result.fill(BandMatrix(count));
    for (std::size_t span = 3; span < count; ++span) {
        const double half = (knots[span + 1] - knots[span]) / 2;
        if (half <= 0) continue;
        for (const GaussPoint& point : gauss) {
            const double at = knots[span] + half * (1 + point.at);
            const auto jet = jets(knots, at, half / 16);
            for (std::size_t order = 0; order < 3; ++order)
                for (std::size_t i = 0; i < 4; ++i)
                    for (std::size_t k = i; k < 4; ++k)
                        result[order][span - 3 + i][k - i] +=
                            half * point.weight * jet[order][i] * jet[order][k];
        }
    }
    return result;
}

} // namespace qm
