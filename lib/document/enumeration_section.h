/// \file The section `enumeration`.
#pragma once

#include "base/at.h"
#include "basecomplex/base_complex.h"
#include "document/json_place.h"
#include "enumerate/enumerate.h"

namespace qm {

/// The separatrix of a base complex that begins with a halfedge.
class SeparatrixIndex {
public:
    SeparatrixIndex(const QuadMesh& mesh, const BaseComplex& complex);
    /// Invalid if there is none.
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

/// The cost that the search used.
[[nodiscard]] GraphCost readCost(const JsonPlace& section);

struct EnumerationContext {
    const QuadMesh& mesh;
    const BaseComplex& baseComplex; ///< without seeds
    const BaseComplex& complex;     ///< with seeds
    const std::vector<double>& edgeCosts;
    const CostTerms& terms;
    const SubMeshes& subMeshes;
};

/// Graphs may have been edited: every track must be the beginning of a separatrix that starts in its
/// sub-mesh, or, in class tmesh, a stretch of one, and no edge may lie on two tracks of a graph. Costs are
/// added up anew; those that are given must agree.
[[nodiscard]] Enumeration readEnumeration(const EnumerationContext& context, const JsonPlace& section);

} // namespace qm
