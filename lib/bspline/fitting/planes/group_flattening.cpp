#include "bspline/fitting/planes/group_flattening.h"

#include "base/at.h"
#include "base/grid_neighbours.h"
#include "base/parallel.h"
#include "bspline/fitting/planes/min_change.h"
#include "bspline/splines/eigen_point.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace qm {
namespace {

/// Relative to the largest distance from the origin, like `planePrecision`.
constexpr double rounding = 1e-12;

/// The largest movement, in multiples of the distance that was missing: planes that can hardly be reached
/// push all patches around away.
constexpr double tooMuch = 20;

/// The share of the largest blame around from which on patches give up. Less may be the fault of a neighbour,
/// as a demand that cannot be met keeps those around it away, too.
constexpr double worst = 0.8;

/// What the patches of a group demand of their control points.
struct Demands {
    std::vector<PlaneDemand> planes;
    std::vector<std::size_t> placeOf; ///< by demand: that of its patch in the group
};

class GroupFlattening {
public:
    GroupFlattening(const MovingGroup& group, std::vector<std::optional<FlatPatch>>& flat,
                    std::vector<Patch>& patches)
        : group_(group), flat_(flat), patches_(patches), points_(eigenIndex(group.unknowns), 3) {
        std::size_t unknown = 0;
        for (const std::size_t patch : group_.patches)
            for (const Point& point : patches_[patch].controlPoints)
                points_.row(eigenIndex(unknown++)) = vector(point);
        size_ = points_.rowwise().norm().maxCoeff();
    }

    bool run() {
        constexpr int attempts = 12;
        Demands wanted = demands();
        if (isFlat(wanted)) return false;
        const MinChange change(group_.unknowns, group_.equations, neighbouringPoints());
        for (int k = 0; k < attempts; ++k, wanted = demands()) {
            if (isFlat(wanted)) return false;
            if (const Eigen::MatrixX3d flat = change.run(wanted.planes, points_);
                accept(wanted, flat, change.violation(flat - points_))) {
                replacePoints(flat);
                return true;
            }
        }
        return false;
    }

private:
    [[nodiscard]] std::vector<NeighbouringPoints> neighbouringPoints() const {
        std::vector<NeighbouringPoints> neighbours;
        std::size_t first = 0;
        for (const std::size_t patch : group_.patches) {
            const std::size_t count = patches_[patch].controlPoints.size();
            forGridNeighbours(at(patches_[patch].count[0]), count, [&](std::size_t a, std::size_t b) {
                neighbours.push_back({first + a, first + b});
            });
            first += count;
        }
        return neighbours;
    }

    [[nodiscard]] Demands demands() const {
        Demands result;
        std::size_t first = 0;
        for (std::size_t place = 0; place < group_.patches.size(); ++place) {
            const std::size_t patch = group_.patches[place];
            if (flat_[patch])
                for (const PlaneDemand& demand : demandsOf(patches_[patch], *flat_[patch], first)) {
                    result.planes.push_back(demand);
                    result.placeOf.push_back(place);
                }
            first += patches_[patch].controlPoints.size();
        }
        return result;
    }

    /// Whether all demands are met already.
    [[nodiscard]] bool isFlat(const Demands& wanted) const {
        return wanted.planes.empty() ||
               missingHeights(wanted.planes, points_).lpNorm<Eigen::Infinity>() <= rounding * size_;
    }

    /// Whether all planes are reached, and nothing is pushed too far for that; if not, gives up what is to
    /// blame.
    /// \param violation  of the equations
    bool accept(const Demands& wanted, const Eigen::MatrixX3d& flat, double violation) {
        const double tooFar = planePrecision * size_;
        const Eigen::VectorXd left = missingHeights(wanted.planes, flat).cwiseAbs();
        if (left.maxCoeff() > tooFar) {
            giveUp(largestOf(wanted, left), tooFar);
            return false;
        }
        const double before = missingHeights(wanted.planes, points_).lpNorm<Eigen::Infinity>();
        const double allowed = tooMuch * before + tooFar;
        const Eigen::VectorXd moved = (flat - points_).rowwise().norm();
        if (moved.maxCoeff() <= allowed && violation <= rounding * size_) return true;
        giveUp(pushing(wanted, moved, allowed), 0);
        return false;
    }

    /// By place in the group: the largest of its demands' values.
    [[nodiscard]] std::vector<double> largestOf(const Demands& demands, const Eigen::VectorXd& values) const {
        std::vector<double> largest(group_.patches.size());
        for (std::size_t k = 0; k < demands.placeOf.size(); ++k)
            largest[demands.placeOf[k]] = std::max(largest[demands.placeOf[k]], values[eigenIndex(k)]);
        return largest;
    }

    /// By place in the group: the largest of the values there and as far as patches move with a plane.
    [[nodiscard]] std::vector<double> largestAround(std::vector<double> values) const {
        for (int ring = 0; ring < ringsAroundPlanes; ++ring) {
            const std::vector<double> before = values;
            for (const auto& [one, other] : group_.neighbours) {
                values[one] = std::max(values[one], before[other]);
                values[other] = std::max(values[other], before[one]);
            }
        }
        return values;
    }

    /// By place in the group: how far its demands move points, if they are near a patch that is moved too
    /// far.
    /// \param moved  by unknown
    [[nodiscard]] std::vector<double> pushing(const Demands& demands, const Eigen::VectorXd& moved,
                                              double allowed) const {
        Eigen::VectorXd ofDemands(eigenIndex(demands.planes.size()));
        for (std::size_t k = 0; k < demands.planes.size(); ++k)
            ofDemands[eigenIndex(k)] = moved[eigenIndex(demands.planes[k].unknown)];
        std::vector<double> ofPatch;
        Eigen::Index unknown = 0;
        for (const std::size_t patch : group_.patches) {
            const Eigen::Index count = eigenIndex(patches_[patch].controlPoints.size());
            ofPatch.push_back(moved.segment(unknown, count).maxCoeff());
            unknown += count;
        }
        std::vector<double> all = largestOf(demands, ofDemands);
        std::vector<double> near = all;
        const std::vector<double> around = largestAround(std::move(ofPatch));
        for (std::size_t place = 0; place < near.size(); ++place)
            if (around[place] <= allowed) near[place] = 0;
        return std::ranges::max(near) > 0 ? near : all;
    }

    /// Gives up what the worst demands are for, everywhere in the group.
    /// \param blame  by place: of its worst demand
    /// \param limit  blame that is not too large, unless all is below it
    void giveUp(const std::vector<double>& blame, double limit) {
        const std::vector<double> around = largestAround(blame);
        const double least = std::min(limit, worst * std::ranges::max(blame));
        for (std::size_t place = 0; place < blame.size(); ++place)
            if (blame[place] > 0 && blame[place] >= std::max(least, worst * around[place]))
                giveUpOne(flat_[group_.patches[place]]);
    }

    /// Gives up the straight sides of a plane patch or, if it has none, its plane.
    static void giveUpOne(std::optional<FlatPatch>& flat) {
        auto& outlines = flat->outlines;
        if (std::ranges::any_of(outlines, [](const auto& outline) { return outline.has_value(); }))
            outlines = {};
        else
            flat.reset();
    }

    void replacePoints(const Eigen::MatrixX3d& flat) {
        std::size_t unknown = 0;
        for (const std::size_t patch : group_.patches)
            for (Point& to : patches_[patch].controlPoints)
                to = point(Eigen::Vector3d(flat.row(eigenIndex(unknown++))));
    }

    const MovingGroup& group_;
    std::vector<std::optional<FlatPatch>>& flat_;
    std::vector<Patch>& patches_;
    Eigen::MatrixX3d points_; ///< before flattening
    double size_ = 0; ///< their largest distance from the origin, relative to which roundings are measured
};

} // namespace

bool flattenGroup(const MovingGroup& group, std::vector<std::optional<FlatPatch>>& flat,
                  std::vector<Patch>& patches) {
    return GroupFlattening(group, flat, patches).run();
}

bool flatten(const KnotPlan& plan, std::vector<std::optional<FlatPatch>>& flat, std::vector<Patch>& patches,
             unsigned jobs) {
    const std::vector<MovingGroup> groups = movingGroups(plan, flat, patches);
    std::vector<char> hasMoved(groups.size());
    parallelFor(groups.size(), jobs, [&](std::size_t k) {
        if (flattenGroup(groups[k], flat, patches)) hasMoved[k] = 1;
    });
    return std::ranges::find(hasMoved, 1) != hasMoved.end();
}

} // namespace qm
