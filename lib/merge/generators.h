/// \file The partial and the complete generator: they turn the graphs of the sub-meshes into one graph
/// without free particles (docs/METHOD.md#merging).
#pragma once

#include "base/control.h"
#include "enumerate/enumeration.h"
#include "enumerate/sub_mesh/search_space.h"
#include "merge/merge.h"

#include <cstddef>
#include <vector>

namespace qm {

struct GeneratorLimits {
    double complexity = 0; ///< chi: fewer particles are taken if a closed set of linked ones is this complex
    int rounds = 0;        ///< of CMG
    /// Limit of the simplex method's work in one search, ten times what all but few need: about a second. In
    /// a sub-mesh dense with extraordinary vertices, a first graph may take minutes.
    std::size_t work = 20'000'000;
};

struct GeneratedGraph {
    PresentArcs present;
    MergeResult figures; ///< the generators' counters
};

/// Runs PMG, then CMG, and extends the remaining free particles straight on. The result does not depend on
/// `control.jobs`, and may break constraints.
/// \throw Error  if it is proven that no graph of some sub-mesh obeys the constraints
[[nodiscard]] GeneratedGraph generateGraph(const SearchedMesh& searched, const SearchSpace& space,
                                           const Enumeration& enumeration, const GeneratorLimits& limits,
                                           const Control& control);

} // namespace qm
