/// \file The search for motorcycle graphs, sub-mesh by sub-mesh (method 2, 3, 5, 10; paper 3.3, 4.2.2).
#pragma once

#include "base/control.h"
#include "basecomplex/base_complex.h"
#include "enumerate/constraints.h"
#include "enumerate/enumeration.h"

#include <functional>
#include <limits>

namespace qm {

struct EnumerationOptions {
    GraphCost cost;
    GraphClass graphClass = GraphClass::motorcycle;
    Method method = Method::optimum;
    std::size_t best = 1;   ///< keep this many graphs of each sub-mesh, the cheapest first
    bool count = false;     ///< count the graphs of each sub-mesh exactly
    std::size_t sample = 0; ///< draw this many graphs of each sub-mesh, all equally likely
    std::size_t seed = 1;   ///< of these draws
    double maxCost = std::numeric_limits<double>::infinity();   ///< only graphs up to this cost
    double timeLimit = std::numeric_limits<double>::infinity(); ///< seconds, for all sub-meshes together
    double gap = 0; ///< stop a sub-mesh when cost - lowerBound is at most this
    Constraints constraints;
};

/// Where a sub-mesh search works: the whole mesh when labels is empty.
struct SubMeshes {
    std::vector<int> labels; ///< sub-mesh of every vertex
    int count = 1;
};

/// Finds the best graphs of every sub-mesh on its own: only particles that start inside move, each up to the
/// first vertex outside. Sub-meshes are searched on `control.jobs` threads; the result does not depend on how
/// many. \param complex  base complex with the feature seeds \throw Error  if a sub-mesh admits no graph
/// under the constraints, or if a cut mesh is to have class tmesh or the plain graph: these know no free
/// particles
[[nodiscard]] Enumeration enumerateGraphs(const QuadMesh& mesh, const BaseComplex& complex,
                                          const std::vector<double>& dihedralAngles,
                                          const SubMeshes& subMeshes, const EnumerationOptions& options,
                                          const Control& control = {});

/// Hands every graph to `visit` exactly once, sub-mesh by sub-mesh, in bounded memory; or, ranked, the best
/// of each sub-mesh, the cheapest first. The search ends early when `visit` returns false. \return false if
/// it was ended early
bool forEachGraph(const QuadMesh& mesh, const BaseComplex& complex, const std::vector<double>& dihedralAngles,
                  const SubMeshes& subMeshes, const EnumerationOptions& options, bool ranked,
                  const std::function<bool(int subMesh, const MotorcycleGraph& graph)>& visit,
                  const Control& control = {});

} // namespace qm
