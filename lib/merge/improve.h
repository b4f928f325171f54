/// \file Improving a complete graph, with a bound for the whole mesh (docs/METHOD.md#improvement).
#pragma once

#include "base/control.h"
#include "base/known_cost.h"
#include "enumerate/sub_mesh/search_space.h"
#include "enumerate/window/window_search.h"
#include "layout/motorcycle_graph.h"

#include <vector>

namespace qm {

struct Improvement {
    MotorcycleGraph graph;
    double lowerBound = 0;        ///< no graph of the mesh is cheaper, to rounding; the cost itself if proven
    std::size_t windows = 0;      ///< searched
    std::size_t improvements = 0; ///< of them, those that made the graph cheaper
};

/// Searches the whole mesh for a share of the time, with fast windows on the way, which often yields the
/// proof. If it does not, windows of all sizes; the rest of the time goes into the bound. The cost never
/// rises and the graph is valid at every step.
/// \param graph       a valid motorcycle graph of the whole mesh that obeys the constraints
/// \param cornerCost  of every corner of a segment
/// \param seconds     in all; without a limit, the result is proven
/// \param control     if it is stopped, the best so far
/// \param tell        told what is known
[[nodiscard]] Improvement improveGraph(const QuadMesh& mesh, const BaseComplex& complex,
                                       const std::vector<double>& edgeCosts, double cornerCost,
                                       const Constraints& constraints, const MotorcycleGraph& graph,
                                       double seconds, const Control& control = {},
                                       const KnownCost& tell = {});

/// A lower bound of a graph's cost, freed of rounding.
/// \throw std::logic_error  if it is clearly above the cost, which is a fault of what computed it
[[nodiscard]] double boundBelow(double lowerBound, double cost);

/// Searches windows that are no harder than a sub-mesh, wherever the cut runs; of very many, the first.
/// \param present     the arcs of a valid graph of the whole mesh
/// \param complexity  chi, of the sub-meshes
[[nodiscard]] WindowResult moveCuts(const SearchSpace& space, const std::vector<bool>& present,
                                    double complexity, const Control& control = {});

} // namespace qm
