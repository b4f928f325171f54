/// \file A whole mesh as a search problem, at the default costs, without features and without a cut.
#pragma once

#include "basecomplex/base_complex.h"
#include "enumerate/enumeration.h"
#include "enumerate/state/problem.h"

namespace qm::bench {

[[nodiscard]] Problem searchProblem(const QuadMesh& mesh, const BaseComplex& complex,
                                    GraphClass graphClass = GraphClass::motorcycle);

[[nodiscard]] Problem searchProblem(const QuadMesh& mesh, GraphClass graphClass = GraphClass::motorcycle);

} // namespace qm::bench
