/// \file Merging the graphs of the sub-meshes into one motorcycle graph of the whole mesh
/// (docs/METHOD.md#merging).
#pragma once

#include "base/control.h"
#include "base/infinity.h"
#include "enumerate/enumerate.h"

namespace qm {

struct MergeOptions {
    int maxRounds = 100; ///< rounds of the complete generator before free particles are extended straight on
    double improve = 0;  ///< seconds for improving the complete graph
    /// Seconds for all searches together, the improvement included. With constraints, the generators end
    /// first.
    double timeLimit = infinity;
};

struct MergeResult {
    MotorcycleGraph graph;
    std::optional<double> lowerBound; ///< for the whole mesh, if known
    std::size_t rounds = 0;           ///< of the complete generator
    std::size_t searches = 0;         ///< searches of sub-meshes in both generators
    std::size_t freeAfterPartial = 0; ///< free particles left by the partial generator
    std::size_t linked = 0;           ///< linked particles that took part in searches, in total
    std::size_t extended = 0;         ///< free particles that were extended straight on
    bool plain = false;               ///< whether the plain motorcycle graph was cheaper than the merged one
    double costBefore = 0;            ///< of the complete graph, before it was improved
    std::size_t windows = 0;          ///< searched to improve it
    std::size_t improvements = 0;     ///< windows that made it cheaper
    bool endedEarly = false;          ///< whether the time limit ended a search
};

/// Runs PMG, then CMG until no particle is free, then searches across the cut, then improves the graph if
/// there is time for it. If the graphs of all sub-meshes are valid motorcycle graphs, the result is one of
/// the whole mesh.
/// \param enumeration      the first graph of every sub-mesh is the starting point; its cost options apply
/// \param tell             called with the known cost and bound during the improvement
/// \param complexityLimit  chi of the cut
[[nodiscard]] MergeResult mergeGraphs(const SearchedMesh& searched, const Enumeration& enumeration,
                                      double complexityLimit, const MergeOptions& options,
                                      const Control& control = {}, const KnownCost& tell = {});

} // namespace qm
