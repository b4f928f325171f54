#include "bspline/solver/dense_elimination.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <random>

namespace qm {
namespace {

/// Symmetric, with pivots of both signs.
Eigen::MatrixXd quasiDefinite(Eigen::Index size) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> value(-1, 1);
    Eigen::MatrixXd matrix(size, size);
    for (Eigen::Index i = 0; i < size; ++i)
        for (Eigen::Index j = 0; j <= i; ++j)
            matrix(i, j) = matrix(j, i) = value(random);
    for (Eigen::Index k = 0; k < size; ++k)
        matrix(k, k) += (k % 3 == 0 ? -1 : 1) * static_cast<double>(size);
    return matrix;
}

DenseFront frontOf(const Eigen::MatrixXd& matrix, Eigen::Index width) {
    const Eigen::Index size = matrix.rows() - width;
    return {matrix.leftCols(width), matrix.bottomRightCorner(size, size)};
}

TEST(EliminateColumns, LeavesFactorsAndTheSchurComplement) {
    struct Case {
        Eigen::Index size;
        Eigen::Index width;
    };
    for (const auto& [size, width] : {Case{1, 1}, Case{5, 2}, Case{40, 40}, Case{90, 70}, Case{400, 50}}) {
        const Eigen::MatrixXd matrix = quasiDefinite(size);
        DenseFront front = frontOf(matrix, width);
        eliminateColumns(front, 2);
        const Eigen::MatrixXd top = front.columns.topRows(width).triangularView<Eigen::UnitLower>();
        const Eigen::MatrixXd below = front.columns.bottomRows(size - width);
        const Eigen::MatrixXd scaled = top * front.columns.diagonal().asDiagonal();
        const double tolerance = 1e-13 * matrix.norm();
        EXPECT_LT((scaled * top.transpose() - matrix.topLeftCorner(width, width)).norm(), tolerance);
        EXPECT_LT((below * scaled.transpose() - matrix.bottomLeftCorner(size - width, width)).norm(),
                  tolerance);
        if (width == size) continue; // nothing remains
        const Eigen::MatrixXd complement = matrix.bottomRightCorner(size - width, size - width) -
                                           matrix.bottomLeftCorner(size - width, width) *
                                               matrix.topLeftCorner(width, width)
                                                   .partialPivLu()
                                                   .solve(matrix.topRightCorner(width, size - width));
        const Eigen::MatrixXd difference = (front.rest - complement).triangularView<Eigen::Lower>();
        EXPECT_LT(difference.norm(), tolerance);
    }
}

TEST(EliminateColumns, IsTheSameOnAnyNumberOfThreads) {
    const Eigen::MatrixXd matrix = quasiDefinite(700);
    DenseFront one = frontOf(matrix, 90);
    DenseFront many = one;
    eliminateColumns(one, 1);
    eliminateColumns(many, 3);
    EXPECT_EQ(one.columns, many.columns);
    EXPECT_EQ(one.rest, many.rest);
}

} // namespace
} // namespace qm
