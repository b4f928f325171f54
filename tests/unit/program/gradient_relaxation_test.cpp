#include "base/infinity.h"
#include "program/decomposition_bound.h"
#include "program/gradient_relaxation.h"
#include "program/sparse_rows.h"

#include <gtest/gtest.h>

namespace qm {
namespace {

/// A ring of columns in which at least one of two neighbours must be 1; the relaxation sets all to one half.
IntegerProgram ring(std::size_t columns) {
    IntegerProgram program;
    program.costs.assign(columns, 1);
    for (std::size_t k = 0; k < columns; ++k)
        program.rows.push_back({{ColumnId(k), ColumnId((k + 1) % columns)}, {1, 1}, 1, infinity});
    return program;
}

TEST(GradientRelaxation, IsNearTheRelaxedOptimum) {
    const IntegerProgram program = ring(101);
    const NearOptimum found = relaxByGradients(program, {100000, 1e-6});
    EXPECT_NEAR(found.lowerBound, 50.5, 1e-3);
    EXPECT_LE(found.lowerBound, 50.5 + 1e-9);
    EXPECT_NEAR(dualBound(program, found.duals), found.lowerBound, 1e-9);
    for (const double value : found.values)
        EXPECT_NEAR(value, 0.5, 1e-3);
}

TEST(GradientRelaxation, KnowsEquationsAndUpperSides) {
    IntegerProgram program;
    program.costs = ColumnValues(std::vector<double>{-3, -2, 1});
    program.rows.push_back({{ColumnId(0), ColumnId(1)}, {1, 1}, -infinity, 1.5});
    program.rows.push_back({{ColumnId(1), ColumnId(2)}, {1, -1}, 0, 0});
    // The cheapest solution is (1, 0.5, 0.5).
    const NearOptimum found = relaxByGradients(program, {100000, 1e-6});
    EXPECT_NEAR(found.lowerBound, -3.5, 1e-3);
    EXPECT_NEAR(program.cost(found.values), -3.5, 1e-2);
}

TEST(GradientRelaxation, IsTrueWheneverItIsStopped) {
    const IntegerProgram program = ring(101);
    double last = -infinity;
    for (const std::size_t iterations : {0U, 1U, 100U, 1000U, 10000U}) {
        const NearOptimum found = relaxByGradients(program, {iterations, 0});
        EXPECT_EQ(found.values.size(), 101U);
        EXPECT_LE(found.lowerBound, 50.5 + 1e-9) << iterations << " iterations";
        EXPECT_GE(found.lowerBound, last) << iterations << " iterations";
        last = found.lowerBound;
    }
    EXPECT_GT(last, 50);
    Control stopped;
    stopped.stopRequested = [] { return true; };
    EXPECT_LE(relaxByGradients(program, {}, stopped).lowerBound, 50.5);
}

TEST(DualBound, ADualOfAnInfiniteSideProvesNothing) {
    const IntegerProgram program = ring(3);
    EXPECT_EQ(dualBound(program, IdVector<RowId, double>(std::vector<double>{-1, 0, 0})), 0);
    EXPECT_EQ(dualBound(program, IdVector<RowId, double>(std::vector<double>{1, 0, 0})), 1);
}

TEST(DualBound, IsTheCostOfARelaxedOptimum) {
    const IntegerProgram program = ring(5);
    EXPECT_DOUBLE_EQ(dualBound(program, IdVector<RowId, double>(std::vector<double>(5, 0.5))), 2.5);
    // Columns with negative reduced cost count with that cost.
    EXPECT_DOUBLE_EQ(dualBound(program, IdVector<RowId, double>(std::vector<double>(5, 0.75))), 1.25);
}

TEST(SparseRows, MultiplyAsWrittenOut) {
    IntegerProgram program;
    program.costs.assign(3, 0);
    program.rows.push_back({{ColumnId(2), ColumnId(0)}, {0.5, -3}, 0, 1});
    program.rows.push_back({{}, {}, 0, 1});
    program.rows.push_back({{ColumnId(2)}, {2}, 0, 1});
    const SparseRows rows(program);
    ASSERT_EQ(rows.size(), 3U);
    EXPECT_EQ(rows.product(0, {1, 10, 100}), 47);
    EXPECT_EQ(rows.product(1, {1, 10, 100}), 0);
    EXPECT_EQ(rows.product(2, {1, 10, 100}), 200);
    EXPECT_EQ(rows.absoluteSum(0), 3.5);
    const SparseRows columns = rows.transposed(3);
    ASSERT_EQ(columns.size(), 3U);
    EXPECT_EQ(columns.product(0, {1, 10, 100}), -3);
    EXPECT_EQ(columns.product(1, {1, 10, 100}), 0);
    EXPECT_EQ(columns.product(2, {1, 10, 100}), 200.5);
}

TEST(DecompositionBound, IsTrueWithAnyDuals) {
    RelaxedProgram relaxed;
    relaxed.program = ring(101); // an integral solution needs 51 columns
    relaxed.values.assign(101, 0.5);
    for (const double dual : {0.0, 0.1, 0.5, 0.7, 3.0}) {
        relaxed.duals.assign(101, dual);
        for (const std::size_t columns : {1U, 2U, 3U, 10U, 1000U}) {
            const double bound = decompositionBound(relaxed, {columns, columns, 1e9});
            EXPECT_LE(bound, 51 + 1e-6) << dual << ", " << columns;
            EXPECT_GE(bound, dualBound(relaxed.program, relaxed.duals) - 1e-6) << dual << ", " << columns;
            if (columns == 1000) {
                EXPECT_NEAR(bound, 51, 1e-6);
            }
        }
    }
}

} // namespace
} // namespace qm
