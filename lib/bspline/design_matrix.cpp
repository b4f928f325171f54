#include "bspline/design_matrix.h"

namespace qm {

std::vector<double> sampleParameters(int edges, int steps) {
    std::vector<double> parameters;
    for (int k = 0; k <= edges * steps; ++k)
        parameters.push_back(static_cast<double>(k) / steps);
    return parameters;
}

SparseMatrix designMatrix(std::span<const double> knots, std::span<const double> parameters,
                          double startWeight, double endWeight) {
    std::vector<Eigen::Triplet<double, int>> entries;
    entries.reserve(4 * parameters.size() + 8);
    int row = 0;
    for (const double parameter : parameters) {
        const BasisValues basis = basisValues(knots, 3, parameter);
        for (std::size_t k = 0; k < 4; ++k)
            if (basis.value[k] != 0)
                entries.emplace_back(row, static_cast<int>(basis.first + k), basis.value[k]);
        ++row;
    }
    const auto addDerivative = [&](double parameter, double weight) {
        const BasisValues basis = basisValues(knots, 3, parameter);
        for (std::size_t k = 0; k < 4 && weight > 0; ++k)
            if (basis.derivative[k] != 0)
                entries.emplace_back(row, static_cast<int>(basis.first + k), weight * basis.derivative[k]);
        ++row;
    };
    addDerivative(parameters.front(), startWeight);
    addDerivative(parameters.back(), endWeight);
    SparseMatrix matrix(row, static_cast<int>(knots.size()) - 4);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

} // namespace qm
