#include "bspline/fitting/energy/gram.h"

#include "bspline/splines/basis.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace qm {
namespace {

struct GaussPoint {
    double at; ///< position, from -1 to 1
    double weight;
};

/// Gauss points that are exact up to degree 7; a product of two cubics has degree 6.
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

void add(double weight, const std::array<double, 4>& values, Matrix4& matrix) {
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t k = 0; k < 4; ++k)
            matrix[i][k] += weight * values[i] * values[k];
}

} // namespace

std::vector<GramPiece> gramPieces(std::span<const double> knots) {
    std::vector<GramPiece> pieces;
    for (std::size_t span = 3; span + 4 < knots.size(); ++span)
        for (double begin = knots[span]; begin < knots[span + 1];) {
            const double end = std::min(std::floor(begin) + 1, knots[span + 1]);
            const double half = (end - begin) / 2;
            GramPiece piece{span - 3, static_cast<std::size_t>(begin)};
            for (const GaussPoint& point : gauss) {
                const auto jet = jets(knots, begin + half * (1 + point.at), half / 16);
                add(half * point.weight, jet[0], piece.values);
                add(half * point.weight, jet[1], piece.slopes);
                add(half * point.weight, jet[2], piece.bends);
            }
            pieces.push_back(piece);
            begin = end;
        }
    return pieces;
}

} // namespace qm
