/// \file Improving a complete graph, with a lower bound for the whole mesh (docs/METHOD.md#improvement).
#pragma once

#include "base/control.h"
#include "enumerate/sub_mesh/search_space.h"
#include "enumerate/window/window_search.h"

namespace qm {

struct Improvement : WindowResult {
    double lowerBound = 0; ///< of all graphs' costs with those of corners; the graph's own if proven
};

/// For a share of the time, searches the whole mesh, and windows at the same time; this often ends with a
/// proof. Without one, goes on with windows of all sizes and with the decomposition bound. The graph is valid
/// at every step and its cost never rises.
/// \param space    of a mesh that is not cut
/// \param present  the arcs of a valid graph of the whole mesh that obeys the constraints
/// \param seconds  in total; without a limit, the result is proven
/// \param control  if it asks to stop, the best result so far is returned
/// \param tell     called with the known cost and bound
[[nodiscard]] Improvement improveGraph(const SearchSpace& space, PresentArcs present, double seconds,
                                       const Control& control = {}, const KnownCost& tell = {});

/// A lower bound without the rounding errors that may lift it above the cost.
/// \throw std::logic_error  if the bound is clearly above the cost, which is a fault of its computation
[[nodiscard]] double boundBelow(double lowerBound, double cost);

} // namespace qm
