#include "bspline/fitting/plane_patches.h"

#include "bspline/fitting/constrained_system.h"
#include "bspline/fitting/continuity_equations.h"
#include "bspline/splines/eigen_point.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <span>

namespace qm {
namespace {

/// \param patches  whose reference points the plane is laid through
std::optional<Plane> planeThrough(const std::vector<ReferenceGrid>& reference,
                                  std::span<const std::size_t> patches, double tolerance) {
    const auto forEachPoint = [&](const auto& f) {
        for (const std::size_t patch : patches)
            for (const Point& at : reference[patch].points)
                f(vector(at));
    };
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    double count = 0;
    forEachPoint([&](const Eigen::Vector3d& at) {
        middle += at;
        ++count;
    });
    middle /= count;
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    forEachPoint([&](const Eigen::Vector3d& at) { spread += (at - middle) * (at - middle).transpose(); });
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);
    // What is no more than a line has no plane of its own.
    if (!(solver.eigenvalues()[1] > tolerance * tolerance * count)) return std::nullopt;
    const Eigen::Vector3d normal = solver.eigenvectors().col(0);
    double farthest = 0;
    forEachPoint(
        [&](const Eigen::Vector3d& at) { farthest = std::max(farthest, std::abs(normal.dot(at - middle))); });
    if (!(farthest <= tolerance)) return std::nullopt;
    return Plane{point(normal), normal.dot(middle)};
}

/// The least change of all control points that puts some of them into planes, under equations that hold
/// already: found by conjugate gradients for the distances from the planes, in the space of what the
/// equations allow.
class Flattening {
public:
    Flattening(const std::vector<LinearForm>& equations, const std::vector<PatchSpace>& spaces,
               const std::vector<std::optional<Plane>>& planes)
        : unknowns_(static_cast<Eigen::Index>(unknownsOf(spaces))),
          allowed_(unknownsOf(spaces), identity(unknowns_), equations) {
        for (std::size_t k = 0; k < spaces.size(); ++k)
            for (std::size_t i = 0; planes[k] && i < spaces[k].size(); ++i)
                demands_.push_back({static_cast<Eigen::Index>(spaces[k].firstUnknown + i),
                                    vector(planes[k]->normal), planes[k]->offset});
    }

    /// \param points  a row for every control point
    [[nodiscard]] Eigen::MatrixX3d run(Eigen::MatrixX3d points) const {
        constexpr int passes = 4; // the later ones mend the rounding of those before
        for (int k = 0; k < passes; ++k)
            points = improved(points);
        return points;
    }

private:
    struct Demand {
        Eigen::Index unknown = 0;
        Eigen::Vector3d normal;
        double offset = 0;
    };

    [[nodiscard]] Eigen::MatrixX3d improved(const Eigen::MatrixX3d& points) const {
        constexpr int maxSteps = 60;
        constexpr double enough = 1e-15; // of the size of the points
        const auto count = static_cast<Eigen::Index>(demands_.size());
        const double size = points.rowwise().norm().maxCoeff();
        Eigen::VectorXd residual(count);
        for (Eigen::Index k = 0; k < count; ++k)
            residual[k] = demand(k).offset - points.row(demand(k).unknown).dot(demand(k).normal);
        Eigen::VectorXd pressure = Eigen::VectorXd::Zero(count);
        Eigen::VectorXd direction = residual;
        double square = residual.squaredNorm();
        for (int k = 0; k < maxSteps && residual.lpNorm<Eigen::Infinity>() > enough * size; ++k) {
            const Eigen::VectorXd effect = distances(allowed(spread(direction), Accuracy::draft));
            const double curvature = direction.dot(effect);
            if (!(curvature > 0)) break;
            const double step = square / curvature;
            pressure += step * direction;
            residual -= step * effect;
            const double next = residual.squaredNorm();
            direction = residual + next / square * direction;
            square = next;
        }
        return allowed(points + spread(pressure), Accuracy::rounding);
    }

    [[nodiscard]] const Demand& demand(Eigen::Index k) const { return demands_[static_cast<std::size_t>(k)]; }

    static std::vector<Eigen::Triplet<double>> identity(Eigen::Index size) {
        std::vector<Eigen::Triplet<double>> entries;
        for (Eigen::Index k = 0; k < size; ++k)
            entries.emplace_back(static_cast<int>(k), static_cast<int>(k), 1);
        return entries;
    }

    [[nodiscard]] Eigen::MatrixX3d spread(const Eigen::VectorXd& pressure) const {
        Eigen::MatrixX3d push = Eigen::MatrixX3d::Zero(unknowns_, 3);
        for (Eigen::Index k = 0; k < pressure.size(); ++k)
            push.row(demand(k).unknown) += pressure[k] * demand(k).normal.transpose();
        return push;
    }

    [[nodiscard]] Eigen::VectorXd distances(const Eigen::MatrixX3d& change) const {
        Eigen::VectorXd result(static_cast<Eigen::Index>(demands_.size()));
        for (Eigen::Index k = 0; k < result.size(); ++k)
            result[k] = change.row(demand(k).unknown).dot(demand(k).normal);
        return result;
    }

    /// What comes nearest to the points among what the equations allow.
    [[nodiscard]] Eigen::MatrixX3d allowed(const Eigen::MatrixX3d& points, Accuracy accuracy) const {
        Eigen::MatrixX3d solution;
        allowed_.improve(points, accuracy, solution);
        return solution.topRows(unknowns_);
    }

    Eigen::Index unknowns_;
    ConstrainedSystem allowed_;
    std::vector<Demand> demands_;
};

} // namespace

std::vector<std::optional<Plane>> planesOf(const std::vector<ReferenceGrid>& reference,
                                           const SmoothNetwork& network, double tolerance) {
    std::vector<std::size_t> group(reference.size()); // a patch of the same group, or itself
    std::iota(group.begin(), group.end(), 0);
    const auto root = [&](std::size_t patch) {
        while (group[patch] != patch)
            patch = group[patch] = group[group[patch]];
        return patch;
    };
    std::vector<bool> isPlane(reference.size());
    for (std::size_t k = 0; k < reference.size(); ++k)
        isPlane[k] = planeThrough(reference, std::span(&k, 1), tolerance).has_value();
    for (const SmoothRun& run : network.runs) {
        const auto& sides = network.stretches[run.stretch].sides;
        if (isPlane[sides[0].patch] && isPlane[sides[1].patch])
            group[root(sides[0].patch)] = root(sides[1].patch);
    }
    std::vector<std::vector<std::size_t>> members(reference.size());
    for (std::size_t k = 0; k < reference.size(); ++k)
        if (isPlane[k]) members[root(k)].push_back(k);
    std::vector<std::optional<Plane>> planes(reference.size());
    for (const auto& ofGroup : members) {
        if (ofGroup.empty()) continue;
        const auto plane = planeThrough(reference, ofGroup, tolerance);
        for (const std::size_t patch : ofGroup)
            planes[patch] = plane;
    }
    return planes;
}

void flatten(const Layout& layout, const SmoothNetwork& network, const std::vector<PatchSpace>& spaces,
             const std::vector<std::optional<Plane>>& planes, std::vector<Patch>& patches) {
    if (std::ranges::none_of(planes, [](const auto& plane) { return plane.has_value(); })) return;
    Eigen::MatrixX3d points(static_cast<Eigen::Index>(unknownsOf(spaces)), 3);
    const auto row = [&](std::size_t patch, std::size_t k) {
        return static_cast<Eigen::Index>(spaces[patch].firstUnknown + k);
    };
    for (std::size_t patch = 0; patch < patches.size(); ++patch)
        for (std::size_t k = 0; k < patches[patch].controlPoints.size(); ++k)
            points.row(row(patch, k)) = vector(patches[patch].controlPoints[k]);
    const Flattening flattening(continuityEquations(layout, network, spaces), spaces, planes);
    const Eigen::MatrixX3d flat = flattening.run(points);
    for (std::size_t patch = 0; patch < patches.size(); ++patch)
        for (std::size_t k = 0; k < patches[patch].controlPoints.size(); ++k)
            patches[patch].controlPoints[k] = point(Eigen::Vector3d(flat.row(row(patch, k))));
}

} // namespace qm
