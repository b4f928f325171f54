/// \file Making one graph of the whole mesh cheaper, by a search of the whole mesh and by windows
/// (docs/METHOD.md#improvement).
#pragma once

#include "base/control.h"
#include "base/infinity.h"
#include "enumerate/optimum/optimum.h"
#include "enumerate/sub_mesh/search_space.h"
#include "enumerate/window/window_search.h"

#include <atomic>
#include <cstddef>

namespace qm {

/// The known cost and lower bound of a graph that is being improved, for callers who want to follow; any
/// thread may set them.
class KnownSoFar {
public:
    /// \param tell  called from any thread; may be empty
    /// Both arguments must outlive the object.
    KnownSoFar(const Control& control, const KnownCost& tell, double cost)
        : control_(control), tell_(tell), cost_(cost) {}

    void setCost(double cost) { cost_ = cost; }
    void setBound(double bound) { bound_ = bound; }

    /// A control for searches that run at the same time: it shows no progress, but reports the known cost and
    /// bound whenever it is asked whether to stop.
    [[nodiscard]] Control control() const {
        Control control = unreported(control_);
        control.stopRequested = [this] {
            if (tell_) tell_(cost_, bound_);
            return control_.stopRequested();
        };
        return control;
    }

private:
    const Control& control_;
    const KnownCost& tell_;
    std::atomic<double> cost_;
    std::atomic<double> bound_ = -infinity;
};

/// The graph is valid at every step, and its cost never rises.
class GraphImprover {
public:
    /// \param present  the arcs of a valid graph
    /// \param known    gets the cost of every cheaper graph, and early bounds
    /// \param large    from this number of variables on, a part is relaxed by gradients and not searched
    /// The space and `known` must outlive the object.
    GraphImprover(const SearchSpace& space, PresentArcs present, KnownSoFar& known,
                  std::size_t large = 15000);

    /// Whether the problem has so many variables that it is only relaxed by gradients: the simplex method
    /// alone would take half a minute.
    [[nodiscard]] bool isLarge() const;

    /// Searches the whole mesh, or relaxes it if it is large, and at the same time windows of the present
    /// graph.
    /// \param control         of the search of the whole mesh
    /// \param ofFirstWindows  of the windows that are searched before the relaxation is known
    /// \return includes the lower bound, and parts left open if none of them is large
    OptimumResult searchTree(const Control& control, const Control& ofFirstWindows);

    /// \param relaxed  the relaxed value of every variable, as `searchTree` returns it; may be empty
    void searchWindows(const IdVector<VariableId, double>& relaxed, WindowOptions options,
                       const Control& control);

    /// The graph, and the windows that have been searched in all.
    [[nodiscard]] const WindowResult& result() const { return result_; }

private:
    void take(const Assignment& graph);
    [[nodiscard]] std::size_t presentVariables() const;
    [[nodiscard]] WindowOptions fastWindows() const;

    const SearchSpace& space_;
    const ProblemInput input_;
    const Problem problem_;
    WindowResult result_;
    KnownSoFar& known_;
    std::size_t large_;
};

} // namespace qm
