/// \file Improving a graph by searching one window of it after another (method 5, mobile cuts).
///
/// A window is a line and those that cross it most; all others stay as they are. What disagrees most with the
/// relaxation is searched first. Windows grow when none of a size improves anything.
#pragma once

#include "base/control.h"
#include "enumerate/problem.h"

#include <vector>

namespace qm {

struct WindowOptions {
    std::size_t leastVariables = 60;  ///< of the smallest windows
    std::size_t mostVariables = 2000; ///< of the largest; a single line may have more
    std::size_t nodes = 200;          ///< of the search tree of one window
};

struct WindowResult {
    Assignment graph;
    double cost = 0;
    std::size_t windows = 0;      ///< searched
    std::size_t improvements = 0; ///< of them, those that led to a cheaper graph
};

/// Ends when no window improves the graph, or when `control.stopRequested`; the graph is valid at every step
/// and its cost never rises. The result does not depend on `control.jobs`.
/// \param start  a valid graph of the problem
[[nodiscard]] WindowResult improveByWindows(const Problem& problem, const Assignment& start,
                                            const WindowOptions& options, const Control& control = {});

} // namespace qm
