#include "bspline/reference/lattice/lagrange.h"

#include "base/at.h"

namespace qm {

LagrangeWeights lagrange(int steps, double parameter) {
    LagrangeWeights weights{};
    for (int k = 0; k <= steps; ++k) {
        Jet& jet = weights[at(k)];
        jet = {1, 0, 0};
        for (int m = 0; m <= steps; ++m) {
            if (m == k) continue;
            const double factor = (parameter * steps - m) / (k - m);
            const double slope = static_cast<double>(steps) / (k - m);
            jet = {jet[0] * factor, jet[1] * factor + jet[0] * slope, jet[2] * factor + 2 * jet[1] * slope};
        }
    }
    return weights;
}

const LagrangeWeights& lagrangeAtEnd(int steps, std::size_t end) {
    static const auto weights = forAllSteps([](int number) {
        return std::array{lagrange(number, 0), lagrange(number, 1)};
    });
    return weights[at(steps - 1)][end];
}

} // namespace qm
