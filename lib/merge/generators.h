/// \file The partial and the complete generator: they turn the graphs of the sub-meshes into one graph
/// without free particles (docs/METHOD.md#merging).
#pragma once

#include "base/control.h"
#include "enumerate/enumeration.h"
#include "enumerate/sub_mesh/search_space.h"
#include "merge/merge.h"

#include <vector>

namespace qm {

struct GeneratedGraph {
    std::vector<bool> present; ///< for every arc, whether the graph has it
    MergeResult figures;       ///< the generators' counters
};

/// Runs PMG, then CMG, and extends the remaining free particles straight on. The result does not depend on
/// `control.jobs`.
/// \param complexityLimit  chi: fewer particles are taken if a closed set of linked ones is this complex
/// \param maxRounds        of CMG
/// \throw Error  if no graph of some sub-mesh obeys the constraints
[[nodiscard]] GeneratedGraph generateGraph(const QuadMesh& mesh, const BaseComplex& complex,
                                           const SearchSpace& space, const Enumeration& enumeration,
                                           const SubMeshes& subMeshes, double complexityLimit, int maxRounds,
                                           const Control& control);

} // namespace qm
