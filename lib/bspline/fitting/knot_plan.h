/// \file Which knots patches have, and how far tangent ratios reach: what a fit refines.
#pragma once

#include "bspline/network/border_strip.h"
#include "bspline/network/smooth_network.h"
#include "bspline/reference/reference_grid.h"
#include "layout/layout.h"

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace qm {

/// Knots along u and along v, of every patch.
using KnotLists = std::vector<std::array<std::vector<double>, 2>>;

/// Lengths of knot intervals along u and along v, in mesh edges, of every patch.
using IntervalLengths = std::vector<std::array<double, 2>>;

/// As long as `minLength` in the mean, and an eighth of a mesh edge at least: the reference is smooth between
/// its vertices.
[[nodiscard]] IntervalLengths shortestIntervals(const std::vector<ReferenceGrid>& grids, double minLength);

/// Begins with no inner knots but those that smoothness asks for, and with ratios that reach from end to end.
class KnotPlan {
public:
    /// \param shortest  intervals, see `shortestIntervals`; an eighth of an edge everywhere if it is empty
    KnotPlan(const Layout& layout, SmoothNetwork network, IntervalLengths shortest = {});

    [[nodiscard]] const SmoothNetwork& network() const { return network_; }

    /// The spline spaces of all patches: the knots chosen, and double ones where tangent ratios end and where
    /// smooth borders turn into creases.
    [[nodiscard]] std::vector<PatchSpace> spaces() const;

    /// Inner knots chosen for a patch along u or v, ascending.
    [[nodiscard]] const std::vector<double>& chosen(std::size_t patch, std::size_t direction) const {
        return chosen_[patch][direction];
    }
    /// \return false if the patch has it already, or it is not inside
    bool insert(std::size_t patch, std::size_t direction, double knot);
    void erase(std::size_t patch, std::size_t direction, double knot);

    /// Lets tangent ratios end at the first knots chosen, and at half the run where they would meet.
    void endAtFirstKnots();

    /// Makes the tangent ratio at one end of a run reach half as far.
    /// \return false if it reaches no farther than the shortest interval
    bool shorten(std::size_t run, std::size_t end);

    /// The shortest interval that knots are to have, in mesh edges: at first twice as long as it may be.
    [[nodiscard]] double minInterval(std::size_t patch, std::size_t direction) const {
        return (allowsShorter_ ? 1 : 2) * shortest_[patch][direction];
    }
    /// \return false if that has been done
    bool allowShorter() { return !std::exchange(allowsShorter_, true); }

private:
    [[nodiscard]] KnotLists doubleKnots() const;
    [[nodiscard]] double firstKnot(const SmoothRun& run, std::size_t end) const;

    std::vector<std::array<int, 2>> sizes_;
    SmoothNetwork network_;
    KnotLists chosen_;
    IntervalLengths shortest_;
    bool allowsShorter_ = false;
    KnotLists turns_; ///< where smooth borders turn into creases
};

} // namespace qm
