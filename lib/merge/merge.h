/// \file From the graphs of the sub-meshes to one motorcycle graph of the whole mesh
/// (docs/METHOD.md#merging).
#pragma once

#include "base/control.h"
#include "base/known_cost.h"
#include "enumerate/enumerate.h"

namespace qm {

struct MergeOptions {
    int maxRounds = 100; ///< passes of the complete generator before free particles are simply extended
    double improve = 0;  ///< seconds to improve the complete graph
};

struct MergeResult {
    MotorcycleGraph graph;
    std::optional<double> lowerBound; ///< for the whole mesh, if one is known
    std::size_t rounds = 0;           ///< passes of the complete generator
    std::size_t searches = 0;         ///< sub-mesh searches in both generators
    std::size_t freeAfterPartial = 0; ///< free particles left by the partial generator
    std::size_t linked = 0;           ///< linked particles that took part in a search, in all
    std::size_t extended = 0;         ///< free particles that had to be extended straight on
    bool plain = false;               ///< the plain motorcycle graph was cheaper than the merged one
    double costBefore = 0;            ///< of the complete graph before it was improved
    std::size_t windows = 0;          ///< searched to improve it
    std::size_t improvements = 0;     ///< of them, those that made it cheaper
};

/// PMG, then CMG until no particle is free, then improvements if there is time. Always ends in a valid
/// motorcycle graph of the whole mesh.
/// \param enumeration  its first graph of every sub-mesh is the starting point; its cost options are used
/// \param tell  told what is known while it improves
/// \param complexityLimit  chi: a closed set of linked particles at least this complex is reduced
[[nodiscard]] MergeResult mergeGraphs(const QuadMesh& mesh, const BaseComplex& complex,
                                      const std::vector<double>& dihedralAngles, const SubMeshes& subMeshes,
                                      const Enumeration& enumeration, const Constraints& constraints,
                                      double complexityLimit, const MergeOptions& options,
                                      const Control& control = {}, const KnownCost& tell = {});

} // namespace qm
