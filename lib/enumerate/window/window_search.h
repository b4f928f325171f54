/// \file Improves a graph by searching one window after another (docs/METHOD.md#windows).
///
/// A window is a chain and those that are closest to it; all others stay fixed. If a relaxed solution is
/// known, windows begin with chains on which the graph disagrees with it, those that disagree most first.
/// Windows grow when none of their size improves the graph.
#pragma once

#include "base/control.h"
#include "enumerate/state/problem.h"

#include <functional>
#include <limits>

namespace qm {

struct WindowOptions {
    std::size_t minVariables = 60; ///< size of the smallest windows
    /// Size of the largest windows; a single chain may be larger.
    std::size_t maxVariables = std::numeric_limits<std::size_t>::max();
    /// Largest number of windows to search in total.
    std::size_t maxWindows = std::numeric_limits<std::size_t>::max();
    /// Limit of the simplex method's work in all windows, see `Relaxation::work`; the last ones may exceed
    /// it.
    std::size_t maxWork = std::numeric_limits<std::size_t>::max();
    /// The same of a single window.
    std::size_t work = std::numeric_limits<std::size_t>::max();
    std::size_t nodes = 50; ///< limit of the search tree of one window, at first
    /// Windows grow along tracks that touch in the graph, not along lines that cross, and their size is that
    /// of the tracks. Their searches take longer and find more.
    bool alongTracks = false;
    bool patient = false; ///< start again with larger search trees when no window helps any more
    IdVector<ArcId, double> relaxed = {}; ///< value of every arc in the relaxed solution; empty if unknown
    /// Called with the arcs of every cheaper graph.
    std::function<void(const PresentArcs& present)> improved = [](const PresentArcs&) {};
};

struct WindowResult {
    PresentArcs present;          ///< the arcs of the graph
    std::size_t windows = 0;      ///< searched
    std::size_t improvements = 0; ///< windows that led to a cheaper graph
};

/// Ends when no window improves the graph, even with larger trees if `patient`, or when
/// `control.stopRequested`. The graph is valid at every step and its cost never rises. The result does not
/// depend on `control.jobs`. The progress is that towards `maxWindows`. Apart from its search, a window takes
/// time linear in its lines and those that cross them.
/// \param input    the whole search; windows consist of its free arcs
/// \param present  the arcs of a graph that is valid in `input`
[[nodiscard]] WindowResult improveByWindows(const ProblemInput& input, const PresentArcs& present,
                                            const WindowOptions& options, const Control& control = {});

} // namespace qm
