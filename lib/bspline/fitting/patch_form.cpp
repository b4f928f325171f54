#include "bspline/fitting/patch_form.h"

#include "bspline/fitting/gram.h"
#include "bspline/splines/eigen_point.h"

#include <algorithm>
#include <cstddef>

namespace qm {
namespace {

/// The entries between a control point and those that come after it: (i + di, j + dj) for dj 0 to 3 and di -3
/// to 3, of which those with dj = 0 and di < 0 stay unused.
class LocalForm {
public:
    LocalForm(std::size_t columns, std::size_t rows) : columns_(columns), entries_(columns * rows * 28) {}

    /// Of control points (i, j) and (i + di, j + dj).
    double& at(std::size_t i, std::size_t j, std::ptrdiff_t di, std::size_t dj) {
        return entries_[((j * columns_ + i) * 4 + dj) * 7 + static_cast<std::size_t>(di + 3)];
    }

    void addTo(std::size_t firstUnknown, std::vector<Eigen::Triplet<double>>& entries) {
        const std::size_t rows = entries_.size() / 28 / columns_;
        const auto columns = static_cast<std::ptrdiff_t>(columns_);
        for (std::size_t j = 0; j < rows; ++j)
            for (std::ptrdiff_t i = 0; i < columns; ++i)
                for (std::size_t dj = 0; dj < 4 && j + dj < rows; ++dj)
                    for (std::ptrdiff_t di = dj == 0 ? 0 : -3; di <= 3; ++di) {
                        if (i + di < 0 || i + di >= columns) continue;
                        const auto column = static_cast<std::ptrdiff_t>(firstUnknown + j * columns_) + i;
                        const auto row =
                            static_cast<std::ptrdiff_t>(firstUnknown + (j + dj) * columns_) + i + di;
                        entries.emplace_back(static_cast<int>(row), static_cast<int>(column),
                                             at(static_cast<std::size_t>(i), j, di, dj));
                    }
    }

private:
    std::size_t columns_;
    std::vector<double> entries_;
};

/// Adds the product of a symmetric matrix along u and one along v.
void addProduct(const BandMatrix& u, const BandMatrix& v, double factor, LocalForm& form) {
    for (std::size_t j = 0; j < v.size(); ++j)
        for (std::size_t dj = 0; dj < 4 && j + dj < v.size(); ++dj)
            for (std::size_t i = 0; i < u.size(); ++i)
                for (std::size_t d = 0; d < 4 && i + d < u.size(); ++d) {
                    const double value = factor * u[i][d] * v[j][dj];
                    const auto di = static_cast<std::ptrdiff_t>(d);
                    form.at(i, j, di, dj) += value;
                    if (d > 0 && dj > 0) form.at(i + d, j, -di, dj) += value;
                }
}

/// The weighted products of the B-splines along u, summed over one row of the lattice.
BandMatrix rowProducts(const std::vector<BasisValues>& basis, const double* weights, std::size_t count) {
    BandMatrix sums(count);
    for (std::size_t k = 0; k < basis.size(); ++k)
        for (std::size_t a = 0; a < 4; ++a)
            for (std::size_t b = a; b < 4; ++b)
                sums[basis[k].first + a][b - a] += weights[k] * basis[k].value[a] * basis[k].value[b];
    return sums;
}

/// Adds a row's sums to all pairs of control points' rows that have a share in it.
void addRow(const BandMatrix& sums, const BasisValues& v, LocalForm& form) {
    for (std::size_t a = 0; a < 4; ++a)
        for (std::size_t b = a; b < 4; ++b) {
            const double share = v.value[a] * v.value[b];
            if (share == 0) continue;
            for (std::size_t i = 0; i < sums.size(); ++i)
                for (std::size_t d = 0; d < 4 && i + d < sums.size(); ++d) {
                    const auto di = static_cast<std::ptrdiff_t>(d);
                    form.at(i, v.first + a, di, b - a) += share * sums[i][d];
                    if (d > 0 && b > a) form.at(i + d, v.first + a, -di, b - a) += share * sums[i][d];
                }
        }
}

} // namespace

void addPatchForm(const PatchSpace& space, const PatchTargets& targets, double bending,
                  std::vector<Eigen::Triplet<double>>& entries) {
    LocalForm form(space.count(0), space.count(1));
    const auto basisU = basisTable(space.knots[0], 3, targets.parameters[0]);
    const auto basisV = basisTable(space.knots[1], 3, targets.parameters[1]);
    for (std::size_t j = 0; j < basisV.size(); ++j)
        addRow(rowProducts(basisU, targets.weights.data() + j * basisU.size(), space.count(0)), basisV[j],
               form);
    const auto u = gramMatrices(space.knots[0]);
    const auto v = gramMatrices(space.knots[1]);
    addProduct(u[2], v[0], bending, form);
    addProduct(u[1], v[1], 2 * bending, form);
    addProduct(u[0], v[2], bending, form);
    form.addTo(space.firstUnknown, entries);
}

void addPatchTargets(const PatchSpace& space, const PatchTargets& targets, Eigen::MatrixX3d& rightHandSide) {
    const auto basisU = basisTable(space.knots[0], 3, targets.parameters[0]);
    const auto basisV = basisTable(space.knots[1], 3, targets.parameters[1]);
    const std::size_t columns = space.count(0);
    Eigen::MatrixX3d row(columns, 3);
    for (std::size_t j = 0; j < basisV.size(); ++j) {
        row.setZero();
        for (std::size_t i = 0; i < basisU.size(); ++i) {
            const std::size_t k = j * basisU.size() + i;
            const Eigen::RowVector3d target = targets.weights[k] * vector(targets.points[k]).transpose();
            for (std::size_t a = 0; a < 4; ++a)
                row.row(static_cast<Eigen::Index>(basisU[i].first + a)) += basisU[i].value[a] * target;
        }
        for (std::size_t b = 0; b < 4; ++b) {
            const auto first =
                static_cast<Eigen::Index>(space.firstUnknown + (basisV[j].first + b) * columns);
            rightHandSide.middleRows(first, static_cast<Eigen::Index>(columns)) += basisV[j].value[b] * row;
        }
    }
}

} // namespace qm
