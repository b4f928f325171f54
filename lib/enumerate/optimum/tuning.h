/// \file Tuning of the search for the optimum. A search that ends with a proof finds the same with any
/// values; its speed depends on them, and so does the best graph of a search that is stopped early.
#pragma once

#include <cstddef>

namespace qm {

struct BranchingTuning {
    /// Probes after which a pseudo-cost is trusted, on the side with fewer: means of fewer are chance.
    static constexpr int probesToTrust = 4;
    /// Largest number of probes at one node: together they should take no longer than a few nodes.
    static constexpr int probesPerNode = 10;
    /// Candidates are tried in the order of their scores; after so many in a row without improvement, the
    /// rest is skipped.
    static constexpr int worseInARow = 4;
    /// Iterations of a probe: the bound grows most in the first ones, and an estimate suffices to compare.
    static constexpr int iterationsPerProbe = 100;
    /// Smaller growth counts as this much, so that the product of both sides still tells candidates apart if
    /// one side has no growth.
    static constexpr double minGrowth = 1e-6;
    /// Smaller moves of a column count as this much, or rounding would look like a steep rate.
    static constexpr double minDistance = 1e-6;
};

struct TreeTuning {
    /// Iterations between two checks for a request to stop: a fraction of a second for the slowest programs.
    static constexpr int iterationsPerSlice = 2000;
    /// Slices after which a relaxation counts as unfinished, because the solver may be cycling.
    static constexpr int maxSlices = 10000;
    /// The same for solving the root again, which was optimal before some columns were fixed.
    static constexpr int maxSlicesAgain = 20;
    /// Share of fixed columns at which the relaxation is built anew. Building costs as much as many solves,
    /// which the smaller program has to repay.
    static constexpr double fixedShareToRebuild = 0.3;
    /// Dives are repeated when the tree has grown by this factor, so their share of the time falls.
    static constexpr std::size_t growthBetweenDives = 4;
};

struct DivingTuning {
    /// Columns above this are fixed together, because it is seldom wrong to round them up.
    static constexpr double sureValue = 0.8;
    /// Between two solves, at least one in `minStep` and at most one in `maxStep` of the fractional columns
    /// are fixed, so that a dive takes a few dozen solves, however many columns there are.
    static constexpr std::size_t minStep = 50;
    static constexpr std::size_t maxStep = 10;
    /// Iterations of one solve; a dive that needs more is not worth its time.
    static constexpr int iterations = 1000;
    /// The same if a search of the rest follows, which is worth more.
    static constexpr int iterationsBeforeSearch = 4 * iterations;
    /// Largest number of free variables after a dive that are searched: parts of this size are usually
    /// proven.
    static constexpr std::size_t smallRest = 1500;
    /// Largest number of free variables in a neighbourhood of the best graph: larger ones are as hard as the
    /// whole.
    static constexpr std::size_t largeRest = 5000;
    /// Limit of the tree of a search within a search.
    static constexpr std::size_t nodes = 100;
};

} // namespace qm
