#include "base/at.h"
#include "bspline/solver/elimination_tree.h"
#include "bspline/solver/sparse_factors.h"
#include "bspline/solver/supernodes.h"

#include <Eigen/LU>
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

Eigen::SparseMatrix<double> inOrder(const Eigen::SparseMatrix<double>& lower, const Permutation& order) {
    Eigen::SparseMatrix<double> ordered(lower.rows(), lower.cols());
    ordered.selfadjointView<Eigen::Lower>() = lower.selfadjointView<Eigen::Lower>().twistedBy(order);
    return ordered;
}

TEST(EliminationTree, HasSubtreesInARowAndTheFactorsEntries) {
    const Eigen::SparseMatrix<double> lower = gridMatrix(12, 4);
    const EliminationTree tree = eliminationTree(lower);
    const auto size = static_cast<int>(lower.rows());
    const Eigen::SparseMatrix<double> ordered = inOrder(lower, tree.order);
    const Eigen::SparseMatrix<double> whole = ordered.selfadjointView<Eigen::Lower>();
    // The factor of a matrix of ones has entries wherever one may be.
    Eigen::MatrixXi factor = Eigen::MatrixXd(whole).cwiseAbs().cwiseSign().cast<int>();
    for (int k = 0; k < size; ++k)
        for (int i = k + 1; i < size; ++i)
            if (factor(i, k) != 0)
                factor.row(i).tail(size - k) =
                    factor.row(i).tail(size - k).cwiseMax(factor.row(k).tail(size - k));
    std::vector<int> subtree(at(size), 1);
    for (int k = 0; k < size; ++k) {
        const Eigen::VectorXi below = factor.col(k).tail(size - k - 1);
        EXPECT_EQ(tree.entries[at(k)], below.sum());
        const int parent = tree.parent[at(k)];
        if (parent == EliminationTree::none) {
            EXPECT_EQ(below.sum(), 0);
            continue;
        }
        Eigen::Index first = 0;
        EXPECT_EQ(below.maxCoeff(&first), 1);
        EXPECT_EQ(parent, k + 1 + static_cast<int>(first));
        subtree[at(parent)] += subtree[at(k)];
    }
    for (int k = 1; k < size; ++k)
        EXPECT_TRUE(subtree[at(k)] == 1 || tree.parent[at(k - 1)] == k) << k;
}

TEST(Supernodes, HoldTheMatrixAndPassTheirRowsOn) {
    const Eigen::SparseMatrix<double> lower = gridMatrix(40, 5);
    const EliminationTree tree = eliminationTree(lower);
    const Eigen::SparseMatrix<double> ordered = inOrder(lower, tree.order);
    const Supernodes plan = planSupernodes(tree, ordered);
    EXPECT_LT(plan.nodes.size(), at(lower.rows()) / 3); // as columns alone they would be slow
    int next = 0;
    for (std::size_t k = 0; k < plan.nodes.size(); ++k) {
        const Supernode& node = plan.nodes[k];
        const auto rows = plan.rowsOf(node);
        EXPECT_EQ(node.begin, next);
        next = node.end;
        EXPECT_TRUE(std::ranges::is_sorted(rows));
        for (int column = node.begin; column < node.end; ++column)
            for (Eigen::SparseMatrix<double>::InnerIterator it(ordered, column); it; ++it)
                EXPECT_TRUE(it.row() < node.end ||
                            std::ranges::binary_search(rows, static_cast<int>(it.row())));
        EXPECT_EQ(node.parent == EliminationTree::none, rows.empty());
        if (rows.empty()) continue;
        const Supernode& parent = plan.nodes[at(node.parent)];
        EXPECT_EQ(std::ranges::count(parent.children, static_cast<int>(k)), 1);
        for (std::size_t row = 0; row < rows.size(); ++row) {
            const int place = plan.placesOf(node)[row];
            EXPECT_EQ(rows[row], place < parent.columns()
                                     ? parent.begin + place
                                     : plan.rowsOf(parent)[at(place - parent.columns())]);
        }
    }
    EXPECT_EQ(next, lower.rows());
}

TEST(Supernodes, PartsNeedNothingOfOneAnother) {
    const Eigen::SparseMatrix<double> lower = gridMatrix(60, 5);
    const EliminationTree tree = eliminationTree(lower);
    const Supernodes plan = planSupernodes(tree, inOrder(lower, tree.order));
    EXPECT_GT(plan.parts.size(), 3U);
    EXPECT_FALSE(plan.parts.back().empty());
    std::vector<std::size_t> partOf(plan.nodes.size(), plan.parts.size());
    for (std::size_t part = 0; part < plan.parts.size(); ++part)
        for (const int supernode : plan.parts[part])
            partOf[at(supernode)] = part;
    EXPECT_EQ(std::ranges::count(partOf, plan.parts.size()), 0);
    for (std::size_t k = 0; k < plan.nodes.size(); ++k) {
        const int parent = plan.nodes[k].parent;
        const std::size_t above = parent == EliminationTree::none ? partOf[k] : partOf[at(parent)];
        EXPECT_TRUE(above == partOf[k] || above + 1 == plan.parts.size());
    }
}

} // namespace
} // namespace qm
