/// \file Writing the section `enumeration`.
#pragma once

#include "base/at.h"
#include "basecomplex/base_complex.h"
#include "document/json/json.h"
#include "enumerate/enumeration.h"

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

} // namespace qm
