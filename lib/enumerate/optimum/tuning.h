/// \file What the search for the optimum is tuned by. A search that ends with a proof finds the same whatever
/// stands here; how soon it ends depends on it, and so does the best graph of a search that is cut short.
#pragma once

#include <array>
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

struct CutTuning {
    /// What a row must be broken by: rows that are broken less move the bound by next to nothing.
    static constexpr double minViolation = 0.05;
    /// Trails begin with arrivals of this value at least; there is nothing to be gained from smaller ones.
    static constexpr double minArrival = 0.2;
    /// ... and where so much of the arrival at least does not pass.
    static constexpr double minLoss = 0.01;
    /// Passes of smaller value lead out of every set that a trail is looked for in.
    static constexpr double slight = 1e-3;
    /// Crossings that a trail is looked for in: where it is lost at all, it is lost sooner.
    static constexpr std::size_t maxCrossings = 400;
    /// Prices of a pass, one after the other: dear ones at first, which make rows of few columns, that take
    /// the solver little time and move the bound most.
    static constexpr std::array prices{0.01, 0.003, 0.001};
    /// What every step adds to a cycle: of cycles that are broken alike, the shortest are the strongest.
    static constexpr double step = 1e-4;
    /// Places that a cycle may lead to: long ones are seldom broken.
    static constexpr std::size_t maxPlaces = 1000;
    /// Where no cycle leads through a side, none leads through those that are as near to it.
    static constexpr double near = 0.02;
    /// Rounds of cuts at the root at most, and how much of the way from bound to cost one must bring.
    static constexpr int maxRounds = 40;
    static constexpr double minGain = 0.002;
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
