#include "bspline/design_matrix.h"

namespace qm {

std::vector<double> sampleParameters(int edges, int steps) {
    std::vector<double> parameters;
    for (int k = 0; k <= edges * steps; ++k)
        parameters.push_back(static_cast<double>(k) / steps);
    return parameters;
}

SparseMatrix designMatrix(std::span<const double> knots, std::span<const double> parameters) {
    const int degree = clampedDegree(knots);
    std::vector<Eigen::Triplet<double, int>> entries;
    entries.reserve(4 * parameters.size());
    int row = 0;
    for (const BasisValues& basis : basisTable(knots, degree, parameters)) {
        for (std::size_t k = 0; k <= static_cast<std::size_t>(degree); ++k)
            entries.emplace_back(row, static_cast<int>(basis.first + k), basis.value[k]);
        ++row;
    }
    SparseMatrix matrix(row, static_cast<int>(knots.size()) - degree - 1);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

} // namespace qm
