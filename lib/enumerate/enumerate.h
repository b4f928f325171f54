/// \file The search for motorcycle graphs in all sub-meshes (docs/METHOD.md#sub-meshes).
#pragma once

#include "base/control.h"
#include "base/infinity.h"
#include "basecomplex/base_complex.h"
#include "enumerate/enumeration.h"
#include "layout/constraints.h"
#include "mesh/sub_meshes.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace qm {

/// What is searched: a mesh, and what is known of it before.
struct SearchedMesh {
    const QuadMesh& mesh;
    const BaseComplex& complex; ///< with the feature seeds
    const std::vector<double>& dihedralAngles;
    const SubMeshes& subMeshes;
    const Constraints& constraints;
};

struct EnumerationOptions {
    GraphCost cost;
    GraphClass graphClass = GraphClass::motorcycle;
    Method method = Method::optimum;
    std::size_t best = 1;        ///< how many graphs of each sub-mesh to keep, the cheapest first
    bool count = false;          ///< whether to count the graphs of each sub-mesh exactly
    std::size_t sample = 0;      ///< how many graphs of each sub-mesh to draw, all equally likely
    std::size_t seed = 1;        ///< of the drawing
    double maxCost = infinity;   ///< ignore graphs that cost more
    double timeLimit = infinity; ///< seconds, for all sub-meshes together
    double gap = 0;              ///< stop the search of a sub-mesh when cost less lower bound is at most this
    Part part;                   ///< the sub-meshes to search
};

/// Finds the best graphs of every sub-mesh by itself: only particles that start inside it move, each as far
/// as the first vertex outside. Works on `control.jobs` threads; the result does not depend on their number.
/// \throw Error  if a sub-mesh has no graph under the constraints, or if class tmesh or the plain graph is
/// asked for on a cut mesh, because neither has free particles
[[nodiscard]] Enumeration enumerateGraphs(const SearchedMesh& searched, const EnumerationOptions& options,
                                          const Control& control = {});

/// The consumers of a list of graphs.
struct GraphListing {
    /// Appends the text of a graph; called on several threads at the same time.
    std::function<void(SubMeshId subMesh, const MotorcycleGraph& graph, std::string& text)> append;
    /// Receives the text of the next graphs of the list. Returning false ends the search early.
    std::function<bool(std::string_view text, std::size_t graphs)> take;
};

/// The graphs of each sub-mesh that are listed.
enum class ListedGraphs {
    every, ///< exactly once each
    best   ///< as many as the options keep, the cheapest first
};

/// Lists graphs, sub-mesh by sub-mesh, in bounded memory. Works on `control.jobs` threads; the list does not
/// depend on their number.
/// \return false if the listing was ended early
bool listGraphs(const SearchedMesh& searched, const EnumerationOptions& options, ListedGraphs which,
                const GraphListing& listing, const Control& control = {});

} // namespace qm
