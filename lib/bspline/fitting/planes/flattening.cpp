#include "bspline/fitting/planes/flattening.h"

#include "base/at.h"
#include "base/disjoint_sets.h"
#include "base/parallel.h"
#include "base/sort_unique.h"
#include "bspline/fitting/planes/min_change.h"
#include "bspline/fitting/system/continuity_equations.h"
#include "bspline/fitting/system/free_patches.h"
#include "bspline/fitting/system/free_unknowns.h"
#include "bspline/splines/eigen_point.h"
#include "layout/sides.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace qm {
namespace {

using FlatPatches = std::vector<std::optional<FlatPatch>>;

/// The plane patches and those within two patches of them; all others stay as they are.
std::vector<bool> movingPatches(const KnotPlan& plan, const FlatPatches& flat) {
    std::vector<bool> moves(flat.size());
    for (std::size_t k = 0; k < flat.size(); ++k)
        moves[k] = flat[k].has_value();
    return withNeighbours(plan.stretches(), std::move(moves), 2);
}

/// Moving patches that are joined by equations, and are not joined to others.
struct Group {
    std::vector<std::size_t> patches;
    std::size_t unknowns = 0;
    std::vector<LinearForm> equations; ///< in the unknowns of the group's patches, one patch after the other
};

/// Divides the patches that move into groups with their patches and unknowns, but no equations yet.
/// \return by patch: its group; patches that stay have none
std::vector<std::size_t> groupPatches(const KnotPlan& plan, const std::vector<PatchSpace>& spaces,
                                      const std::vector<bool>& moves, std::vector<Group>& groups) {
    DisjointSets joined(spaces.size());
    for (const Stretch& stretch : plan.stretches())
        if (moves[stretch.sides[0].patch] && moves[stretch.sides[1].patch])
            joined.join(stretch.sides[0].patch, stretch.sides[1].patch);
    std::vector<std::size_t> groupOf(spaces.size());
    for (std::size_t patch = 0; patch < spaces.size(); ++patch) {
        if (!moves[patch]) continue;
        const std::size_t first = joined.find(patch);
        if (first == patch) {
            groupOf[patch] = groups.size();
            groups.emplace_back();
        }
        Group& group = groups[groupOf[patch] = groupOf[first]];
        group.patches.push_back(patch);
        group.unknowns += spaces[patch].size();
    }
    return groupOf;
}

/// Divides the moving patches and the equations between them into groups.
std::vector<Group> divided(const Layout& layout, const KnotPlan& plan, const std::vector<PatchSpace>& spaces,
                           const std::vector<bool>& moves) {
    std::vector<Group> groups;
    const std::vector<std::size_t> groupOfPatch = groupPatches(plan, spaces, moves, groups);
    // By moving unknown: its group, and its number within the group.
    std::vector<std::size_t> groupOf;
    std::vector<std::size_t> ofGroup;
    std::vector<std::size_t> next(groups.size());
    for (std::size_t patch = 0; patch < spaces.size(); ++patch)
        for (std::size_t k = 0; moves[patch] && k < spaces[patch].size(); ++k) {
            groupOf.push_back(groupOfPatch[patch]);
            ofGroup.push_back(next[groupOfPatch[patch]]++);
        }
    const FreeUnknowns moving(spaces, moves);
    for (const LinearForm& equation : continuityEquations(layout, plan, spaces, moves)) {
        LinearForm form = moving.among(equation);
        if (form.unknowns.empty()) continue;
        Group& group = groups[groupOf[form.unknowns.front()]];
        for (std::size_t& unknown : form.unknowns)
            unknown = ofGroup[unknown];
        group.equations.push_back(std::move(form));
    }
    return groups;
}

/// What the patches of a group demand of their control points.
struct Demands {
    std::vector<PlaneDemand> planes;
    std::vector<std::size_t> patchOf; ///< by demand
};

/// Moves the plane patches of one group into their planes.
class GroupFlattening {
public:
    GroupFlattening(const Group& group, FlatPatches& flat, std::vector<Patch>& patches)
        : group_(group), flat_(flat), patches_(patches), change_(group.unknowns, group.equations),
          points_(static_cast<Eigen::Index>(group.unknowns), 3) {
        std::size_t unknown = 0;
        for (const std::size_t patch : group_.patches)
            for (const Point& point : patches_[patch].controlPoints)
                points_.row(row(unknown++)) = vector(point);
    }

    void run() {
        constexpr int attempts = 12;
        for (int k = 0; k < attempts; ++k)
            if (tryAll()) return;
    }

private:
    static Eigen::Index row(std::size_t unknown) { return static_cast<Eigen::Index>(unknown); }

    Demands demands() const {
        Demands result;
        std::size_t first = 0;
        for (const std::size_t patch : group_.patches) {
            if (flat_[patch]) addOf(patch, first, result);
            first += patches_[patch].controlPoints.size();
        }
        return result;
    }

    /// Adds what a plane patch demands, whose first control point has the number `first`.
    void addOf(std::size_t patch, std::size_t first, Demands& result) const {
        const auto add = [&](std::size_t k, const Plane& plane) {
            result.planes.push_back({first + k, plane});
            result.patchOf.push_back(patch);
        };
        for (std::size_t k = 0; k < patches_[patch].controlPoints.size(); ++k)
            add(k, flat_[patch]->plane);
        const std::array<std::size_t, 2> count{at(patches_[patch].count[0]), at(patches_[patch].count[1])};
        for (int side = 0; side < 4; ++side)
            if (const auto& outline = flat_[patch]->outlines[at(side)])
                for (std::size_t k = 0; k < count[directionAlong(side)]; ++k)
                    add(pointOnSide(count, side, k), *outline);
    }

    /// Gives up what the worst demands are for.
    void giveUp(const Demands& demands, const Eigen::VectorXd& blame) {
        // Share of the largest blame from which on patches give up. Less may be the fault of a neighbour, as
        // a demand that cannot be met keeps those around it away, too.
        constexpr double worst = 0.8;
        std::vector<std::size_t> blamed;
        for (std::size_t k = 0; k < demands.patchOf.size(); ++k)
            if (blame[row(k)] >= worst * blame.maxCoeff()) blamed.push_back(demands.patchOf[k]);
        sortUnique(blamed);
        for (const std::size_t patch : blamed) {
            auto& outlines = flat_[patch]->outlines;
            const bool hasOutlines =
                std::ranges::any_of(outlines, [](const auto& o) { return o.has_value(); });
            if (hasOutlines)
                outlines = {};
            else
                flat_[patch].reset();
        }
    }

    /// \return whether all planes could be reached at once; if not, the worst are dropped and no patch moves
    bool tryAll() {
        const Demands wanted = demands();
        if (wanted.planes.empty()) return true;
        const Eigen::MatrixX3d flat = change_.run(wanted.planes, points_);

        constexpr double rounding = 1e-12;
        constexpr double tooFar = 1e-8;
        // Largest movement, in multiples of the distance that was missing: planes that can hardly be reached
        // push all patches around away.
        constexpr double tooMuch = 20;
        const double size = largestDistance(points_);
        const Eigen::VectorXd left = missingHeights(wanted.planes, flat).cwiseAbs();
        const Eigen::VectorXd moved = (flat - points_).rowwise().norm();
        const double before = missingHeights(wanted.planes, points_).lpNorm<Eigen::Infinity>();
        const bool misses = left.maxCoeff() > tooFar * size;
        if (misses || moved.maxCoeff() > tooMuch * before + tooFar * size ||
            change_.violation(flat - points_) > rounding * size) {
            Eigen::VectorXd blame = left;
            for (Eigen::Index k = 0; !misses && k < blame.size(); ++k)
                blame[k] = moved[row(wanted.planes[at(k)].unknown)];
            giveUp(wanted, blame);
            return false;
        }
        std::size_t unknown = 0;
        for (const std::size_t patch : group_.patches)
            for (Point& to : patches_[patch].controlPoints)
                to = point(Eigen::Vector3d(flat.row(row(unknown++))));
        return true;
    }

    const Group& group_;
    FlatPatches& flat_;
    std::vector<Patch>& patches_;
    MinChange change_;
    Eigen::MatrixX3d points_; ///< before flattening
};

} // namespace

void flatten(const Layout& layout, const KnotPlan& plan, const std::vector<PatchSpace>& spaces,
             FlatPatches flat, std::vector<Patch>& patches, unsigned jobs) {
    const std::vector<Group> groups = divided(layout, plan, spaces, movingPatches(plan, flat));
    parallelFor(groups.size(), jobs, [&](std::size_t k) { GroupFlattening(groups[k], flat, patches).run(); });
}

} // namespace qm
