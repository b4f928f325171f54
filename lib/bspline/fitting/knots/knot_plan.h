/// \file The knots of all patches and the reach of the tangent ratios: what refinement changes.
#pragma once

#include "bspline/network/smooth_network.h"
#include "bspline/reference/lattice/reference_grid.h"
#include "bspline/splines/patch_space.h"
#include "layout/layout.h"

#include <array>
#include <cstddef>
#include <vector>

namespace qm {

/// The knots along u and v of every patch.
using KnotLists = std::vector<std::array<std::vector<double>, 2>>;

/// A knot of a patch along u (0) or v (1).
struct PatchKnot {
    std::size_t patch = 0;
    std::size_t direction = 0;
    double knot = 0;
};

/// An end of a run: 0 where it begins, 1 where it ends.
struct RunEnd {
    std::size_t run = 0;
    std::size_t end = 0;

    auto operator<=>(const RunEnd&) const = default; // NOLINT(modernize-use-nullptr): no pointer
};

/// The lengths of knot intervals along u and v of every patch, in mesh edges.
using IntervalLengths = std::vector<std::array<double, 2>>;

/// The parts of a mesh edge, in every patch, that are as long as a given length on average.
[[nodiscard]] IntervalLengths partsOfEdges(const std::vector<ReferenceGrid>& grids, double length);

/// How short intervals may become, as a part of a mesh edge. The reference is smooth between its vertices, so
/// short ones are seldom needed: where the mesh is coarse, and few vertices make strong bends. With
/// `quarter`, the length that a plan is given as the shortest counts twice.
enum class MinInterval { quarter, eighth, thirtySecond };

/// Begins with only those inner knots that smoothness requires, and with tangent ratios that reach from end
/// to end.
class KnotPlan {
public:
    /// \param network   must outlive the plan
    /// \param shortest  intervals are no shorter, whatever `MinInterval` allows; empty if there is no limit
    /// \param twice     inner knots that are double besides those that smoothness requires; empty if none are
    KnotPlan(const Layout& layout, const SmoothNetwork& network, IntervalLengths shortest = {},
             const KnotLists& twice = {});

    [[nodiscard]] const std::vector<Stretch>& stretches() const { return *stretches_; }
    [[nodiscard]] const std::vector<SmoothRun>& runs() const { return runs_; } ///< with their present ratios

    /// The spline spaces of all patches: the chosen knots, double knots where tangent ratios end, and those
    /// that are always double.
    [[nodiscard]] std::vector<PatchSpace> spaces() const;

    /// The inner knots that are double wherever tangent ratios end, ascending: where smooth borders turn into
    /// creases, and those that the plan was given.
    [[nodiscard]] const KnotLists& alwaysDouble() const { return alwaysDouble_; }
    /// The sizes of all patches, in quads.
    [[nodiscard]] const std::vector<std::array<int, 2>>& sizes() const { return sizes_; }

    /// The chosen inner knots of a patch along u (0) or v (1), ascending.
    [[nodiscard]] const std::vector<double>& chosen(std::size_t patch, std::size_t direction) const {
        return chosen_[patch][direction];
    }
    /// \return false if the patch has this knot already or the knot is not inside the patch
    bool insert(std::size_t patch, std::size_t direction, double knot);
    void erase(std::size_t patch, std::size_t direction, double knot);

    /// Ends each tangent ratio at the first chosen knot, or at half of its run where the two ends would
    /// overlap.
    void endAtFirstKnots();

    /// The knots inside the two patches of a run at which its tangent ratio ends with this reach.
    [[nodiscard]] std::vector<PatchKnot> knotsAt(const RunEnd& end, double reach) const;

    /// \param reach  along the run, such that the two ends do not overlap
    void setReach(const RunEnd& end, double reach) { runs_[end.run].ratio.reach[end.end] = reach; }

    /// Lets the tangent ratio at one end of a run reach no farther. A linear one becomes quadratic, and ends
    /// at half of its run at the latest.
    void limitReach(const RunEnd& end, double max);

    /// Halves the reach of the tangent ratio at one end of a run.
    /// \return false if it is as short as the shortest interval already
    bool shorten(const RunEnd& end);

    /// The shortest interval that a knot may make, in mesh edges.
    [[nodiscard]] double minInterval(std::size_t patch, std::size_t direction) const;
    /// \return false if intervals as short as these were allowed before
    bool allow(MinInterval length);

private:
    [[nodiscard]] KnotLists doubleKnots() const;
    [[nodiscard]] double firstKnot(const RunEnd& end) const;

    std::vector<std::array<int, 2>> sizes_;
    const std::vector<Stretch>* stretches_;
    std::vector<SmoothRun> runs_;
    KnotLists chosen_;
    IntervalLengths shortest_;
    MinInterval minInterval_ = MinInterval::quarter;
    KnotLists alwaysDouble_;
};

} // namespace qm
