/// \file The section `enumeration`; it is read in `read_enumeration.cpp`.
#pragma once

#include "base/at.h"
#include "basecomplex/base_complex.h"
#include "document/json/json_place.h"
#include "enumerate/enumeration.h"
#include "mesh/sub_meshes.h"

#include <vector>

namespace qm {

/// Finds the separatrix of a base complex that begins with a given halfedge.
class SeparatrixIndex {
public:
    SeparatrixIndex(const QuadMesh& mesh, const BaseComplex& complex);
    /// The separatrix; none if no separatrix begins with the halfedge.
    [[nodiscard]] SeparatrixId startingWith(HalfedgeId halfedge) const { return starts_[at(halfedge)]; }

private:
    std::vector<SeparatrixId> starts_; ///< by halfedge
};

/// {"cost", "tracks": [{"separatrix"|"source", "vertices"}]}
/// \param baseComplex  index of the base complex without seeds, whose numbers the document uses
[[nodiscard]] Json graphToJson(const QuadMesh& mesh, const SeparatrixIndex& baseComplex,
                               const MotorcycleGraph& graph);

[[nodiscard]] Json enumerationToJson(const QuadMesh& mesh, const SeparatrixIndex& baseComplex,
                                     const Enumeration& enumeration);

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
