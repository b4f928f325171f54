/// \file Improving a graph by searching one window of it after another (docs/METHOD.md#windows).
///
/// A window is a line and those that cross it most; all others stay as they are. Lines on which the graph and
/// the relaxed solution disagree come first. Windows grow when none of a size improves anything.
#pragma once

#include "base/control.h"
#include "enumerate/state/problem.h"

#include <functional>
#include <limits>
#include <vector>

namespace qm {

struct WindowOptions {
    std::size_t minVariables = 60; ///< of the smallest windows
    /// Of the largest windows; a single line may have more.
    std::size_t maxVariables = std::numeric_limits<std::size_t>::max();
    std::size_t maxWindows = std::numeric_limits<std::size_t>::max(); ///< in all
    std::size_t nodes = 50;      ///< of the search tree of one window, at first
    bool patient = false;        ///< when no window helps any more, begin again with larger trees
    std::vector<double> relaxed; ///< value of every arc in the relaxed solution; empty if there is none
    /// Told the arcs of every cheaper graph.
    std::function<void(const std::vector<bool>& present)> improved = [](const std::vector<bool>&) {};
};

struct WindowResult {
    std::vector<bool> present;    ///< of every arc
    std::size_t windows = 0;      ///< searched
    std::size_t improvements = 0; ///< of them, those that led to a cheaper graph
};

/// Ends when no window improves the graph (patient: when none could), or when `control.stopRequested`. The
/// graph is valid at every step and its cost never rises. The result does not depend on `control.jobs`. What
/// a window takes beside its search is linear in its lines and those across them.
/// \param input    the whole search; its free arcs are those that windows are made of
/// \param present  the arcs of a graph that is valid in it
[[nodiscard]] WindowResult improveByWindows(const ProblemInput& input, const std::vector<bool>& present,
                                            const WindowOptions& options, const Control& control = {});

} // namespace qm
