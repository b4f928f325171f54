/// \file The partial and the complete generator: from the graphs of the sub-meshes to one graph in which no
/// particle is free (docs/METHOD.md#merging).
#pragma once

#include "base/control.h"
#include "enumerate/enumeration.h"
#include "enumerate/sub_mesh/search_space.h"
#include "merge/merge.h"

#include <vector>

namespace qm {

struct GeneratedGraph {
    std::vector<bool> present; ///< of every arc
    MergeResult figures;       ///< what the generators count
};

/// PMG, then CMG, and straight on what they leave free. The result does not depend on `control.jobs`.
/// \param complexityLimit  chi: a closed set of linked particles at least this complex is reduced
/// \param maxRounds  of CMG
/// \throw Error  if no graph of a sub-mesh obeys the constraints
[[nodiscard]] GeneratedGraph generateGraph(const QuadMesh& mesh, const BaseComplex& complex,
                                           const SearchSpace& space, const Enumeration& enumeration,
                                           const SubMeshes& subMeshes, double complexityLimit, int maxRounds,
                                           const Control& control);

} // namespace qm
