#include "bspline/fitting/sparse_factors.h"

#include <Eigen/LU>
#include <Eigen/OrderingMethods>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <vector>

namespace qm {
namespace {

using Entries = std::vector<Eigen::Triplet<double>>;

/// The quasi-definite matrix of a square grid of unknowns, each tied to its neighbours, with equations
/// between some neighbours.
Eigen::SparseMatrix<double> gridMatrix(int width, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> weight(0.1, 2);
    Entries entries;
    const auto tie = [&](int one, int other) {
        const double w = weight(random);
        entries.emplace_back(one, one, w);
        entries.emplace_back(other, other, w);
        entries.emplace_back(std::max(one, other), std::min(one, other), -w);
    };
    const int unknowns = width * width;
    int size = unknowns;
    for (int k = 0; k < unknowns; ++k) {
        entries.emplace_back(k, k, 0.01);
        if (k % width > 0) tie(k, k - 1);
        if (k >= width) tie(k, k - width);
        if (k % 7 == 0 && k > width) {
            entries.emplace_back(size, k, 1);
            entries.emplace_back(size, k - width, -weight(random));
            entries.emplace_back(size, size, -0.1);
            ++size;
        }
    }
    Eigen::SparseMatrix<double> lower(size, size);
    lower.setFromTriplets(entries.begin(), entries.end());
    return lower;
}

Eigen::MatrixX3d randomRows(Eigen::Index size) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> value(-1, 1);
    Eigen::MatrixX3d rows(size, 3);
    for (Eigen::Index k = 0; k < rows.size(); ++k)
        rows.data()[k] = value(random);
    return rows;
}

TEST(SparseFactors, SolvesAsDenseEliminationDoes) {
    for (const int width : {1, 2, 5, 12, 25}) {
        const Eigen::SparseMatrix<double> lower = gridMatrix(width, 1);
        const Eigen::MatrixX3d right = randomRows(lower.rows());
        const Eigen::SparseMatrix<double> whole = lower.selfadjointView<Eigen::Lower>();
        const Eigen::MatrixX3d expected = Eigen::MatrixXd(whole).fullPivLu().solve(right);
        const Eigen::MatrixX3d found = SparseFactors(lower, 2).solve(right);
        EXPECT_LT((found - expected).norm(), 1e-12 * expected.norm()) << width;
    }
}

TEST(SparseFactors, AreTheSameOnAnyNumberOfThreads) {
    const Eigen::SparseMatrix<double> lower = gridMatrix(60, 2);
    const Eigen::MatrixX3d right = randomRows(lower.rows());
    const Eigen::MatrixX3d one = SparseFactors(lower, 1).solve(right);
    for (const unsigned jobs : {2U, 5U})
        EXPECT_EQ(SparseFactors(lower, jobs).solve(right), one);
}

TEST(SparseFactors, TakeMatricesWithoutAnyTies) {
    Eigen::SparseMatrix<double> diagonal(3, 3);
    const Entries entries = {{0, 0, 2}, {1, 1, -4}, {2, 2, 1}};
    diagonal.setFromTriplets(entries.begin(), entries.end());
    const Eigen::MatrixX3d right = Eigen::MatrixX3d::Ones(3, 3);
    const Eigen::MatrixX3d found = SparseFactors(diagonal, 2).solve(right);
    EXPECT_EQ(found.col(0), Eigen::Vector3d(0.5, -0.25, 1));
    EXPECT_EQ(SparseFactors(Eigen::SparseMatrix<double>(0, 0), 2).solve(Eigen::MatrixX3d(0, 3)).rows(), 0);
}

TEST(EliminationPlan, PartsNeedNothingOfOneAnother) {
    const Eigen::SparseMatrix<double> lower = gridMatrix(30, 5);
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> inverse;
    Eigen::AMDOrdering<int>()(lower.selfadjointView<Eigen::Lower>(), inverse);
    Eigen::SparseMatrix<double> upper(lower.rows(), lower.cols());
    upper.selfadjointView<Eigen::Upper>() =
        lower.selfadjointView<Eigen::Lower>().twistedBy(inverse.inverse());
    const EliminationPlan plan = planElimination(upper);
    EXPECT_GT(plan.rest(), 3);
    EXPECT_FALSE(plan.columns.back().empty());
    std::size_t columns = 0;
    for (std::size_t part = 0; part < plan.columns.size(); ++part)
        for (const int column : plan.columns[part]) {
            ++columns;
            EXPECT_EQ(plan.part[static_cast<std::size_t>(column)], static_cast<int>(part));
            const int parent = plan.parent[static_cast<std::size_t>(column)];
            if (parent == EliminationPlan::none) continue;
            EXPECT_GT(parent, column);
            const int above = plan.part[static_cast<std::size_t>(parent)];
            EXPECT_TRUE(above == static_cast<int>(part) || above == plan.rest());
        }
    EXPECT_EQ(columns, static_cast<std::size_t>(lower.rows()));
}

} // namespace
} // namespace qm
