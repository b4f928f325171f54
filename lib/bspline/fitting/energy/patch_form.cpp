#include "bspline/fitting/energy/patch_form.h"

#include "bspline/fitting/energy/gram.h"
#include "bspline/splines/eigen_point.h"

#include <cstddef>

namespace qm {
namespace {

/// The entries between a control point (i, j) and the later ones (i + di, j + dj) for dj from 0 to 3 and di
/// from -3 to 3; those with dj = 0 and di < 0 are not used.
class LocalForm {
public:
    LocalForm(std::size_t columns, std::size_t rows) : columns_(columns), entries_(columns * rows * 28) {}

    /// The entry of control points (i, j) and (i + di, j + dj).
    double& at(std::size_t i, std::size_t j, std::ptrdiff_t di, std::size_t dj) {
        return entries_[((j * columns_ + i) * 4 + dj) * 7 + static_cast<std::size_t>(di + 3)];
    }

    /// The lower half.
    [[nodiscard]] Eigen::SparseMatrix<double> matrix() {
        const std::size_t rows = entries_.size() / 28 / columns_;
        const auto columns = static_cast<std::ptrdiff_t>(columns_);
        Eigen::SparseMatrix<double> lower(eigenIndex(rows * columns_), eigenIndex(rows * columns_));
        lower.reserve(eigenIndex(entries_.size()));
        for (std::size_t j = 0; j < rows; ++j)
            for (std::ptrdiff_t i = 0; i < columns; ++i) {
                const Eigen::Index column = eigenIndex(j * columns_) + i;
                lower.startVec(column);
                for (std::size_t dj = 0; dj < 4 && j + dj < rows; ++dj)
                    for (std::ptrdiff_t di = dj == 0 ? 0 : -3; di <= 3; ++di)
                        if (i + di >= 0 && i + di < columns)
                            lower.insertBack(eigenIndex((j + dj) * columns_) + i + di, column) =
                                at(static_cast<std::size_t>(i), j, di, dj);
            }
        lower.finalize();
        return lower;
    }

private:
    std::size_t columns_;
    std::vector<double> entries_;
};

/// Adds the thin-plate energy over one piece in each direction.
void addBending(const GramPiece& u, const GramPiece& v, const ThinPlate& plate, LocalForm& form) {
    for (std::size_t j = 0; j < 4; ++j)
        for (std::size_t dj = 0; j + dj < 4; ++dj)
            for (std::size_t i = 0; i < 4; ++i)
                for (std::size_t k = dj == 0 ? i : 0; k < 4; ++k) {
                    const double energy = plate.uu * u.bends[i][k] * v.values[j][j + dj] +
                                          plate.uv * u.slopes[i][k] * v.slopes[j][j + dj] +
                                          plate.vv * u.values[i][k] * v.bends[j][j + dj];
                    form.at(u.first + i, v.first + j,
                            static_cast<std::ptrdiff_t>(k) - static_cast<std::ptrdiff_t>(i), dj) += energy;
                }
}

/// A symmetric band matrix: entry (i, i + d) is at [i][d], for d from 0 to 3.
using BandMatrix = std::vector<std::array<double, 4>>;

/// The weighted products of the B-splines along u, summed over one row of the lattice.
BandMatrix rowProducts(const std::vector<BasisValues>& basis, const double* weights, std::size_t count) {
    BandMatrix sums(count);
    for (std::size_t k = 0; k < basis.size(); ++k)
        for (std::size_t a = 0; a < 4; ++a)
            for (std::size_t b = a; b < 4; ++b)
                sums[basis[k].first + a][b - a] += weights[k] * basis[k].value[a] * basis[k].value[b];
    return sums;
}

/// Adds the sums of one lattice row to all pairs of rows of control points that it depends on.
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

Eigen::SparseMatrix<double> patchForm(const PatchSpace& space, const PatchTargets& targets,
                                      const std::vector<ThinPlate>& plates) {
    LocalForm form(space.count(0), space.count(1));
    const auto basisU = basisTable(space.knots[0], 3, targets.parameters[0]);
    const auto basisV = basisTable(space.knots[1], 3, targets.parameters[1]);
    for (std::size_t j = 0; j < basisV.size(); ++j)
        addRow(rowProducts(basisU, targets.weights.data() + j * basisU.size(), space.count(0)), basisV[j],
               form);
    const auto us = gramPieces(space.knots[0]);
    const auto vs = gramPieces(space.knots[1]);
    const std::size_t columns = us.back().quad + 1;
    for (const GramPiece& v : vs)
        for (const GramPiece& u : us)
            addBending(u, v, plates[v.quad * columns + u.quad], form);
    return form.matrix();
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
                row.row(eigenIndex(basisU[i].first + a)) += basisU[i].value[a] * target;
        }
        for (std::size_t b = 0; b < 4; ++b) {
            const auto first = eigenIndex(space.firstUnknown + (basisV[j].first + b) * columns);
            rightHandSide.middleRows(first, eigenIndex(columns)) += basisV[j].value[b] * row;
        }
    }
}

} // namespace qm
