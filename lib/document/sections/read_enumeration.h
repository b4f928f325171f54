/// \file Reading the section `enumeration`.
#pragma once

#include "basecomplex/base_complex.h"
#include "document/json/json_place.h"
#include "enumerate/enumeration.h"
#include "mesh/sub_meshes.h"

#include <vector>

namespace qm {

/// The cost that the search minimised.
[[nodiscard]] GraphCost readCost(const JsonPlace& section);

struct EnumerationContext {
    const QuadMesh& mesh;
    const BaseComplex& baseComplex; ///< without seeds
    const BaseComplex& complex;     ///< with seeds
    const std::vector<double>& edgeCosts;
    const CostTerms& terms;
    const SubMeshes& subMeshes;
};

/// Reads an enumeration. Graphs may have been edited: every track must be the beginning of a separatrix that
/// starts in its sub-mesh or, in class tmesh, a stretch of one, and no edge may lie on two tracks of a graph.
/// Costs are computed anew; costs in the section must agree.
[[nodiscard]] Enumeration readEnumeration(const EnumerationContext& context, const JsonPlace& section);

} // namespace qm
