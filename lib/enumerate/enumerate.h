/// \file The search for motorcycle graphs, sub-mesh by sub-mesh (docs/METHOD.md#sub-meshes).
#pragma once

#include "base/control.h"
#include "basecomplex/base_complex.h"
#include "enumerate/enumeration.h"
#include "enumerate/sub_mesh/search_space.h"
#include "layout/constraints.h"

#include <functional>
#include <limits>
#include <string>
#include <string_view>

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
    Part part;      ///< search these sub-meshes only
    Constraints constraints;
};

/// Finds the best graphs of every sub-mesh on its own: only particles that start inside move, each up to the
/// first vertex outside. Sub-meshes are searched on `control.jobs` threads; the result does not depend on how
/// many.
/// \param complex  base complex with the feature seeds
/// \throw Error  if a sub-mesh admits no graph under the constraints, or if a cut mesh is to have class tmesh
/// or the plain graph: these know no free particles
[[nodiscard]] Enumeration enumerateGraphs(const QuadMesh& mesh, const BaseComplex& complex,
                                          const std::vector<double>& dihedralAngles,
                                          const SubMeshes& subMeshes, const EnumerationOptions& options,
                                          const Control& control = {});

/// What becomes of the graphs of a list.
struct GraphListing {
    /// Appends what is to be said of a graph to a text; called on several threads.
    std::function<void(SubMeshId subMesh, const MotorcycleGraph& graph, std::string& text)> append;
    /// Takes the text of some graphs, in the order of the list; never twice at the same time, but on any
    /// thread. The search ends early when it returns false.
    std::function<bool(std::string_view text, std::size_t graphs)> take;
};

/// Lists every graph exactly once, sub-mesh by sub-mesh, in bounded memory; or, ranked, the best of each
/// sub-mesh, the cheapest first. Works on `control.jobs` threads; the list does not depend on how many.
/// \return false if it was ended early
bool listGraphs(const QuadMesh& mesh, const BaseComplex& complex, const std::vector<double>& dihedralAngles,
                const SubMeshes& subMeshes, const EnumerationOptions& options, bool ranked,
                const GraphListing& listing, const Control& control = {});

} // namespace qm
