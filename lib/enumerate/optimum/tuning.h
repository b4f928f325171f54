/// \file What the search for the optimum is tuned by. A search that ends with a proof finds the same whatever
/// stands here; how soon it ends depends on it, and so does the best graph of a search that is cut short.
#pragma once

#include <cstddef>

namespace qm {

struct BranchingTuning {
    /// A pseudo-cost is trusted after so many probes, on the side that has fewer: means of less are chance.
    static constexpr int probesToTrust = 4;
    /// Probes at one node at most: together they may take as long as a few nodes, not more.
    static constexpr int probesPerNode = 10;
    /// Candidates come in the order of their promise; after so many in a row that are no better, none will
    /// be.
    static constexpr int worseInARow = 4;
    /// Iterations of a probe: the bound grows most in the first ones, and an estimate is enough to compare.
    static constexpr int iterationsPerProbe = 100;
    /// Growth below this counts as this much, so that a product of two tells sides apart when one is 0.
    static constexpr double minGrowth = 1e-6;
    /// Columns moved by less count as moved by this much: rounding would be taken for a steep rate.
    static constexpr double minDistance = 1e-6;
};

struct TreeTuning {
    /// Iterations between two questions whether to stop: a fraction of a second where they are slowest.
    static constexpr int iterationsPerSlice = 2000;
    /// Slices until a relaxation is given up, which then counts as unfinished: the solver may go in circles.
    static constexpr int maxSlices = 10000;
    /// The same when the root is solved again, which was optimal but for what has been fixed since.
    static constexpr int maxSlicesAgain = 20;
    /// Of the gradients that the simplex method begins from: their last digits take longer than the rest of
    /// its way.
    static constexpr double nearlySolved = 2e-2;
    /// The relaxation is set up anew without its fixed columns once they are this share of all: setting up
    /// costs as much as many solves, and a smaller program has to repay it.
    static constexpr double fixedShareToRebuild = 0.3;
    /// Dives are repeated when the tree has grown by this factor, so that their share of the time falls.
    static constexpr std::size_t growthBetweenDives = 4;
};

struct DivingTuning {
    /// Columns above this are fixed together, as rounding them up is seldom wrong.
    static constexpr double sureValue = 0.8;
    /// Between two solves at least one in `minStep` and at most one in `maxStep` of the fractional columns
    /// are fixed: a dive takes some dozens of solves, however many columns there are.
    static constexpr std::size_t minStep = 50;
    static constexpr std::size_t maxStep = 10;
    /// Of one solve; a dive that needs more is not worth it.
    static constexpr int iterations = 1000;
    /// The same where a search of what is left follows, which is worth more.
    static constexpr int iterationsBeforeSearch = 4 * iterations;
    /// Variables in doubt that a search can take over from a dive: such parts are usually proven.
    static constexpr std::size_t smallRest = 1500;
    /// Variables in doubt above which the neighbourhood of the best graph is as hard as the whole.
    static constexpr std::size_t largeRest = 5000;
    /// Of a search within a search.
    static constexpr std::size_t nodes = 100;
};

} // namespace qm
