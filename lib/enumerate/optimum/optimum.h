/// \file The cheapest motorcycle graphs with a proof: branch and bound on arcs (docs/METHOD.md#optimum).
#pragma once

#include "base/control.h"
#include "enumerate/state/search_state.h"
#include "program/decomposition_bound.h"

#include <functional>
#include <limits>
#include <optional>
#include <vector>

namespace qm {

struct OptimumOptions {
    std::size_t best = 1; ///< how many graphs, the cheapest
    double maxCost = std::numeric_limits<double>::infinity();
    double gap = 0;                  ///< stop when cost - lower bound is at most this
    std::optional<Assignment> start; ///< a valid graph to begin with
    std::size_t nodes = 20'000'000;  ///< of the search tree of a part, at most
    /// Makes a valid graph cheaper if it can, by a search of its own; needs a start. Called in hard parts
    /// once they have been relaxed: `relaxed` holds the relaxed value of every variable.
    std::function<Assignment(const Assignment& graph, const IdVector<VariableId, double>& relaxed)> polish =
        {};
    /// A part of at least this many variables is hard: early graphs are looked for by smaller searches.
    std::size_t hard = 1500;
    /// In a part of at least this many variables cuts of the relaxation are looked for; smaller ones are as
    /// soon proven without.
    std::size_t cut = 300;
    /// Of the tree of a part that is not hard; then a decision diagram is tried. Almost all of these trees
    /// are smaller, and where the relaxation says nothing they may grow without end.
    std::size_t nodesBeforeDiagram = 1000;
    /// Of a part of at least this many variables, only the root is searched, and its relaxation is begun by
    /// gradients, as the simplex method alone would take too long. Needs a start.
    std::size_t large = std::numeric_limits<std::size_t>::max();
    bool keepOpenParts = false; ///< return what is not proven, see OptimumResult
};

/// An independent part of a search without a proof.
struct OpenPart {
    RelaxedProgram relaxed;
    double lowerBound = 0; ///< of its cost
};

struct OptimumResult {
    std::vector<Assignment> graphs; ///< cheapest first, ties in lexicographic order of the variables
    double lowerBound = 0;          ///< no graph is cheaper; infinity if there is none at all
    bool complete = true;           ///< all graphs that were asked for are found and proven
    std::size_t nodes = 0;          ///< of the search tree
    /// The relaxed value of every variable at the root of the search, or its value in `start` if the root was
    /// not solved; empty without a start.
    IdVector<VariableId, double> relaxed;
    std::vector<OpenPart> openParts; ///< if wanted: those that have been relaxed, but not proven
};

/// Splits the problem into parts that do not touch, and searches each best first: propagation, the linear
/// relaxation, fixing by reduced costs, and diving for early graphs. The optimum of a small part whose tree
/// grows large all the same is read off a decision diagram. Stops when `control.stopRequested`.
[[nodiscard]] OptimumResult findOptimum(const Problem& problem, const OptimumOptions& options,
                                        const Control& control = {});

/// The same; several graphs are read off a decision diagram where that is small.
[[nodiscard]] OptimumResult findBest(const Problem& problem, const OptimumOptions& options,
                                     const Control& control = {});

/// Calls `visit` with these graphs in the same order; where there is a diagram, as soon as they are known.
/// \return false if `visit` returned false, or not all graphs were found
bool forEachBest(const Problem& problem, const OptimumOptions& options,
                 const std::function<bool(const Assignment&)>& visit, const Control& control = {});

} // namespace qm
