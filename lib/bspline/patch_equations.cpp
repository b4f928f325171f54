#include "bspline/patch_equations.h"

#include "bspline/eigen_point.h"
#include "bspline/profile_factor.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>

namespace qm {

BasisWeights valueWeights(const BasisValues& basis) {
    return {basis.first, {basis.value[0], basis.value[1], basis.value[2], basis.value[3]}};
}

BasisWeights derivativeWeights(const BasisValues& basis) {
    return {basis.first,
            {basis.derivative[0], basis.derivative[1], basis.derivative[2], basis.derivative[3]}};
}

PatchEquations::PatchEquations(const Patch& patch)
    : patch_(patch), inner_{static_cast<std::size_t>(patch.count[0]) - 2,
                            static_cast<std::size_t>(patch.count[1]) - 2},
      matrix_(inner_[0] * inner_[1] * blocks, Eigen::Matrix3d::Zero()),
      right_(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(3 * inner_[0] * inner_[1]))) {}

std::size_t PatchEquations::unknown(std::size_t i, std::size_t j) const {
    // The shorter direction runs faster: that keeps the band narrow.
    return inner_[0] <= inner_[1] ? j * inner_[0] + i : i * inner_[1] + j;
}

void PatchEquations::add(const BasisWeights& u, const BasisWeights& v, const Eigen::Matrix3d& metric,
                         const Point& target) {
    const auto columns = static_cast<std::size_t>(patch_.count[0]);
    struct Term {
        std::size_t fast;
        std::size_t slow;
        std::size_t unknown;
        double weight;
    };
    std::array<Term, span * span> terms;
    std::size_t size = 0;
    const bool uIsFast = inner_[0] <= inner_[1];
    Point rest = target;
    for (std::size_t s = 0; s < span; ++s)
        for (std::size_t f = 0; f < span; ++f) {
            const std::size_t a = uIsFast ? f : s;
            const std::size_t b = uIsFast ? s : f;
            const double weight = u.weight[a] * v.weight[b];
            if (weight == 0) continue;
            const std::size_t i = u.first + a;
            const std::size_t j = v.first + b;
            if (isKnown(i, j))
                rest -= weight * patch_.controlPoints[j * columns + i];
            else
                terms[size++] = {f, s, unknown(i - 1, j - 1), weight};
        }
    const Eigen::Vector3d right = metric * vector(rest);
    for (std::size_t k = 0; k < size; ++k) {
        const Term& one = terms[k];
        right_.segment<3>(static_cast<Eigen::Index>(3 * one.unknown)) += one.weight * right;
        const Eigen::Matrix3d weighted = one.weight * metric;
        Eigen::Matrix3d* row = matrix_.data() + one.unknown * blocks;
        for (std::size_t m = k; m < size; ++m) {
            const Term& other = terms[m];
            // Blocks 0 to 3 lie on the own line, seven on each of the next three.
            const std::size_t block = (other.slow - one.slow) * reach + other.fast - one.fast;
            row[block] += other.weight * weighted;
        }
    }
}

void PatchEquations::addLattice(const std::vector<BasisValues>& us, const std::vector<BasisValues>& vs,
                                std::span<const double> weights, std::span<const Eigen::Matrix3d> metrics,
                                std::span<const Point> targets) {
    const std::size_t columns = static_cast<std::size_t>(patch_.count[0]) + span; // room for weights of zero
    Row row;
    std::size_t k = 0;
    for (const BasisValues& v : vs) {
        row.pairs.assign(columns * span, Eigen::Matrix3d::Zero());
        row.right.assign(columns, Eigen::Vector3d::Zero());
        for (const BasisValues& u : us) {
            const Eigen::Matrix3d metric = weights[k] * metrics[k];
            const Eigen::Vector3d right = metric * vector(targets[k]);
            ++k;
            for (std::size_t a = 0; a < span; ++a) {
                const Eigen::Matrix3d weighted = u.value[a] * metric;
                row.right[u.first + a] += u.value[a] * right;
                for (std::size_t b = a; b < span; ++b)
                    row.pairs[(u.first + a) * span + b - a] += u.value[b] * weighted;
            }
        }
        addRow(valueWeights(v), row);
    }
}

void PatchEquations::addRow(const BasisWeights& v, const Row& row) {
    const auto columns = static_cast<std::size_t>(patch_.count[0]);
    const bool uIsFast = inner_[0] <= inner_[1];
    for (std::size_t a = 0; a < span; ++a) {
        const std::size_t j = v.first + a;
        if (v.weight[a] == 0) continue;
        for (std::size_t i = 1; i <= inner_[0] && !isKnown(i, j); ++i) {
            const std::size_t one = unknown(i - 1, j - 1);
            auto right = right_.segment<3>(static_cast<Eigen::Index>(3 * one));
            right += v.weight[a] * row.right[i];
            for (std::size_t b = 0; b < span; ++b) {
                const std::size_t jb = v.first + b;
                const double weight = v.weight[a] * v.weight[b];
                if (weight == 0) continue;
                for (std::size_t ib = i < span ? 0 : i - span + 1; ib < std::min(i + span, columns); ++ib) {
                    const Eigen::Matrix3d& pair =
                        row.pairs[std::min(i, ib) * span + (i < ib ? ib - i : i - ib)];
                    if (isKnown(ib, jb))
                        right -= weight * (pair * vector(patch_.controlPoints[jb * columns + ib]));
                    else if (const std::size_t other = unknown(ib - 1, jb - 1); other >= one) {
                        const std::size_t line = uIsFast ? jb - j : ib - i;
                        const std::size_t step = uIsFast ? ib - i : jb - j; // wraps where it is negative
                        matrix_[one * blocks + line * reach + step] += weight * pair;
                    }
                }
            }
        }
    }
}

/// Calls visit(row, column, value) for all entries of the lower triangle.
template <class Visitor> void PatchEquations::visitLower(const Visitor& visit) const {
    const std::size_t fast = std::min(inner_[0], inner_[1]);
    const std::size_t slow = std::max(inner_[0], inner_[1]);
    for (std::size_t s = 0; s < slow; ++s)
        for (std::size_t f = 0; f < fast; ++f)
            for (std::size_t block = 0; block < blocks; ++block) {
                const std::size_t line = (block + span - 1) / reach;
                const std::size_t otherFast = f + block - line * reach; // may wrap: then it is large
                if (s + line >= slow || otherFast >= fast) continue;
                const Eigen::Matrix3d& entry = matrix_[(s * fast + f) * blocks + block];
                const auto column = static_cast<Eigen::Index>(3 * (s * fast + f));
                const auto row = static_cast<Eigen::Index>(3 * ((s + line) * fast + otherFast));
                for (Eigen::Index r = 0; r < 3; ++r)
                    for (Eigen::Index c = 0; c < 3; ++c)
                        if (row + r >= column + c) visit(row + r, column + c, entry(r, c));
            }
}

Eigen::VectorXd PatchEquations::solveTogether() const {
    // Row by row from the first entry: its blocks reach back `span` - 1 lines and steps.
    const std::size_t fast = std::min(inner_[0], inner_[1]);
    std::vector<std::size_t> first;
    for (std::size_t k = 0; k < inner_[0] * inner_[1]; ++k) {
        const std::size_t back = std::min(k, (span - 1) * (fast + 1));
        first.insert(first.end(), 3, 3 * (k - back));
    }
    ProfileFactor matrix(std::move(first));
    visitLower([&](Eigen::Index row, Eigen::Index column, double value) {
        matrix.at(static_cast<std::size_t>(row), static_cast<std::size_t>(column)) = value;
    });
    matrix.factorise();
    return matrix.solve(right_);
}

/// Whether the coordinates do not depend on one another, and count alike.
bool PatchEquations::isSeparate() const {
    return std::all_of(matrix_.begin(), matrix_.end(), [](const Eigen::Matrix3d& block) {
        return block == block(0, 0) * Eigen::Matrix3d::Identity();
    });
}

Eigen::VectorXd PatchEquations::solveSeparately() const {
    std::vector<Eigen::Triplet<double, int>> entries;
    visitLower([&](Eigen::Index row, Eigen::Index column, double value) {
        if (row % 3 == 0 && column % 3 == 0)
            entries.emplace_back(static_cast<int>(row / 3), static_cast<int>(column / 3), value);
    });
    const auto size = static_cast<int>(right_.size() / 3);
    Eigen::SparseMatrix<double> matrix(size, size);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>> right(right_.data(),
                                                                                            size, 3);
    const Eigen::MatrixXd columns = right;
    const Eigen::MatrixXd solution =
        Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower>(matrix).solve(columns);
    Eigen::VectorXd result(right_.size());
    for (Eigen::Index k = 0; k < size; ++k)
        result.segment<3>(3 * k) = solution.row(k);
    return result;
}

Patch PatchEquations::solve() const {
    if (right_.size() == 0) return patch_;
    const Eigen::VectorXd points = isSeparate() ? solveSeparately() : solveTogether();
    Patch result = patch_;
    const auto columns = static_cast<std::size_t>(patch_.count[0]);
    for (std::size_t j = 0; j < inner_[1]; ++j)
        for (std::size_t i = 0; i < inner_[0]; ++i) {
            const auto at = static_cast<Eigen::Index>(3 * unknown(i, j));
            result.controlPoints[(j + 1) * columns + i + 1] = {points[at], points[at + 1], points[at + 2]};
        }
    return result;
}

} // namespace qm
