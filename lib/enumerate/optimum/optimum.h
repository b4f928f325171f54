/// \file The cheapest motorcycle graphs, with a proof: branch and bound (docs/METHOD.md#optimum).
#pragma once

#include "base/control.h"
#include "enumerate/optimum/part_options.h"
#include "enumerate/state/search_state.h"
#include "program/decomposition_bound.h"

#include <functional>
#include <optional>
#include <vector>

namespace qm {

struct OptimumOptions : PartOptions {
    std::optional<Assignment> start; ///< a valid graph to begin with
    /// Returns a graph that is at most as expensive as the given one; needs a start. Called for hard parts
    /// after their relaxation; `relaxed` holds the relaxed value of every variable.
    std::function<Assignment(const Assignment& graph, const IdVector<VariableId, double>& relaxed)> polish =
        {};
    /// Learns a lower bound, and says whether to go on to the root. Called for large parts as soon as they
    /// are nearly relaxed, which takes a small share of the time of the relaxation; needs a start.
    std::function<bool(double lowerBound)> near = {};
    /// Limit of the tree of a part that is not hard, before a decision diagram is tried. Few trees grow
    /// larger, but where the relaxation is weak they may grow without end.
    std::size_t nodesBeforeDiagram = 1000;
    bool keepOpenParts = false; ///< fill OptimumResult::openParts
};

/// An independent part that has not been proven.
struct OpenPart {
    RelaxedProgram relaxed;
    double lowerBound = 0; ///< of the cost of the part
};

struct OptimumResult {
    std::vector<Assignment> graphs; ///< cheapest first; several that tie are in lexicographic order
    double lowerBound = 0;          ///< no graph is cheaper; infinity if there is no graph
    bool complete = true;           ///< all graphs asked for are found and proven
    std::size_t nodes = 0;          ///< of all search trees
    std::size_t work = 0;           ///< of the simplex method, see `Relaxation::work`
    /// The relaxed value of every variable at the root of the search, or its value in `start` if its root was
    /// not solved; empty without a start.
    IdVector<VariableId, double> relaxed;
    std::vector<OpenPart> openParts; ///< with `keepOpenParts`: parts that have been relaxed, but not proven
};

/// Searches best first with propagation, the linear relaxation, fixing by reduced costs, and diving for early
/// graphs. For a single graph, every independent part is searched by itself, and if the tree of a part that
/// is not hard grows large, its optimum is read off a decision diagram. Stops when `control.stopRequested`;
/// reports no progress.
[[nodiscard]] OptimumResult findOptimum(const Problem& problem, const OptimumOptions& options,
                                        const Control& control = {});

/// The same, but several graphs are read off a decision diagram if that is small.
[[nodiscard]] OptimumResult findBest(const Problem& problem, const OptimumOptions& options,
                                     const Control& control = {});

/// Calls `visit` with the graphs of `findBest` in their order; with a diagram, as soon as each is known. A
/// single graph may be another of those that tie.
/// \return false if `visit` returned false, or if not all graphs were found
bool forEachBest(const Problem& problem, const OptimumOptions& options,
                 const std::function<bool(const Assignment&)>& visit, const Control& control = {});

} // namespace qm
