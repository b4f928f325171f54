#include "bspline/fitting/flattening.h"

#include "bspline/fitting/constrained_system.h"
#include "bspline/fitting/continuity_equations.h"
#include "bspline/fitting/free_unknowns.h"
#include "bspline/splines/eigen_point.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace qm {
namespace {

/// Plane patches and those within two patches of them: the others stay.
std::vector<bool> movingPatches(const SmoothNetwork& network,
                                const std::vector<std::optional<Plane>>& planes) {
    std::vector<bool> moves(planes.size());
    for (std::size_t k = 0; k < planes.size(); ++k)
        moves[k] = planes[k].has_value();
    return withNeighbours(network, std::move(moves), 2);
}

/// The equations for changes of what moves.
std::vector<LinearForm> equationsAmong(const FreeUnknowns& moving, const std::vector<LinearForm>& equations) {
    std::vector<LinearForm> result;
    for (const LinearForm& equation : equations)
        if (LinearForm form = moving.among(equation); !form.unknowns.empty())
            result.push_back(std::move(form));
    return result;
}

/// The least change of control points that puts some of them into planes, under equations that hold already:
/// found by conjugate gradients for the distances from the planes, in the space of what the equations allow.
class Flattening {
public:
    Flattening(std::size_t unknowns, std::vector<LinearForm> equations)
        : unknowns_(static_cast<Eigen::Index>(unknowns)), equations_(std::move(equations)),
          allowed_(unknowns, identity(unknowns_), equations_) {}

    void demand(Eigen::Index unknown, const Plane& plane) {
        demands_.push_back({unknown, vector(plane.normal), plane.offset});
    }

    /// \param points  a row for every control point that may move
    [[nodiscard]] Eigen::MatrixX3d run(Eigen::MatrixX3d points) const {
        constexpr int passes = 4; // the later ones mend the rounding of those before
        constexpr double enough = 1e-14;
        for (int k = 0; k < passes && missing(points).lpNorm<Eigen::Infinity>() > enough * sizeOf(points);
             ++k)
            points += change(points);
        return points;
    }

    [[nodiscard]] Eigen::Index unknown(Eigen::Index demand) const { return at(demand).unknown; }

    /// By demand, how far the point is below its plane.
    [[nodiscard]] Eigen::VectorXd missing(const Eigen::MatrixX3d& points) const {
        Eigen::VectorXd result = -distances(points);
        for (Eigen::Index k = 0; k < result.size(); ++k)
            result[k] += at(k).offset;
        return result;
    }

    /// By how much a change violates the equations, at most.
    [[nodiscard]] double violation(const Eigen::MatrixX3d& change) const {
        double largest = 0;
        for (const LinearForm& equation : equations_) {
            Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
            for (std::size_t k = 0; k < equation.unknowns.size(); ++k)
                sum += equation.weights[k] * change.row(static_cast<Eigen::Index>(equation.unknowns[k]));
            largest = std::max(largest, sum.norm());
        }
        return largest;
    }

private:
    struct Demand {
        Eigen::Index unknown = 0;
        Eigen::Vector3d normal;
        double offset = 0;
    };

    [[nodiscard]] Eigen::MatrixX3d change(const Eigen::MatrixX3d& points) const {
        constexpr int maxSteps = 60;
        constexpr double enough = 1e-15; // of the size of the points
        const double size = sizeOf(points);
        Eigen::VectorXd residual = missing(points);
        Eigen::VectorXd pressure = Eigen::VectorXd::Zero(residual.size());
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
        return allowed(spread(pressure), Accuracy::rounding);
    }

    static double sizeOf(const Eigen::MatrixX3d& points) { return points.rowwise().norm().maxCoeff(); }

    [[nodiscard]] const Demand& at(Eigen::Index k) const { return demands_[static_cast<std::size_t>(k)]; }

    static std::vector<Eigen::Triplet<double>> identity(Eigen::Index size) {
        std::vector<Eigen::Triplet<double>> entries;
        for (Eigen::Index k = 0; k < size; ++k)
            entries.emplace_back(static_cast<int>(k), static_cast<int>(k), 1);
        return entries;
    }

    [[nodiscard]] Eigen::MatrixX3d spread(const Eigen::VectorXd& pressure) const {
        Eigen::MatrixX3d push = Eigen::MatrixX3d::Zero(unknowns_, 3);
        for (Eigen::Index k = 0; k < pressure.size(); ++k)
            push.row(at(k).unknown) += pressure[k] * at(k).normal.transpose();
        return push;
    }

    /// Along the normals of the planes.
    [[nodiscard]] Eigen::VectorXd distances(const Eigen::MatrixX3d& points) const {
        Eigen::VectorXd result(static_cast<Eigen::Index>(demands_.size()));
        for (Eigen::Index k = 0; k < result.size(); ++k)
            result[k] = points.row(at(k).unknown).dot(at(k).normal);
        return result;
    }

    /// What comes nearest to a change among those that the equations allow.
    [[nodiscard]] Eigen::MatrixX3d allowed(const Eigen::MatrixX3d& change, Accuracy accuracy) const {
        Eigen::MatrixX3d solution;
        allowed_.improve(change, accuracy, solution);
        return solution.topRows(unknowns_);
    }

    Eigen::Index unknowns_;
    std::vector<LinearForm> equations_;
    ConstrainedSystem allowed_;
    std::vector<Demand> demands_;
};

/// \return whether all planes can be had at once; where not, the worst are dropped, and the patches stay
bool tryToFlatten(const Layout& layout, const SmoothNetwork& network, const std::vector<PatchSpace>& spaces,
                  std::vector<std::optional<Plane>>& planes, std::vector<Patch>& patches) {
    const std::vector<bool> moves = movingPatches(network, planes);
    const FreeUnknowns moving(spaces, moves);
    Flattening flattening(moving.count(),
                          equationsAmong(moving, continuityEquations(layout, network, spaces, moves)));
    const auto forEachMoving = [&](const auto& f) {
        for (std::size_t patch = 0; patch < patches.size(); ++patch)
            for (std::size_t k = 0; k < patches[patch].controlPoints.size(); ++k)
                if (const std::size_t unknown = spaces[patch].firstUnknown + k; moving.isFree(unknown))
                    f(patch, static_cast<Eigen::Index>(moving.number(unknown)),
                      patches[patch].controlPoints[k]);
    };
    Eigen::MatrixX3d points(static_cast<Eigen::Index>(moving.count()), 3);
    std::vector<std::size_t> demanding;
    forEachMoving([&](std::size_t patch, Eigen::Index number, const Point& controlPoint) {
        points.row(number) = vector(controlPoint);
        if (!planes[patch]) return;
        flattening.demand(number, *planes[patch]);
        demanding.push_back(patch);
    });
    const Eigen::MatrixX3d flat = flattening.run(points);

    constexpr double rounding = 1e-12;
    constexpr double tooFar = 1e-8;
    constexpr double worst = 0.8; // of the farthest: one that cannot be had keeps its neighbours away as well
    // Times what was missing: planes that can hardly be had push all around away.
    constexpr double tooMuch = 5;
    const double size = points.rowwise().norm().maxCoeff();
    const Eigen::VectorXd missing = flattening.missing(flat).cwiseAbs();
    const Eigen::VectorXd change = (flat - points).rowwise().norm();
    const double before = flattening.missing(points).lpNorm<Eigen::Infinity>();
    const bool misses = missing.maxCoeff() > tooFar * size;
    if (misses || change.maxCoeff() > tooMuch * before + tooFar * size ||
        flattening.violation(flat - points) > rounding * size) {
        Eigen::VectorXd blame = missing;
        for (Eigen::Index k = 0; !misses && k < blame.size(); ++k)
            blame[k] = change[flattening.unknown(k)];
        for (std::size_t k = 0; k < demanding.size(); ++k)
            if (blame[static_cast<Eigen::Index>(k)] >= worst * blame.maxCoeff()) planes[demanding[k]].reset();
        return false;
    }
    forEachMoving([&](std::size_t, Eigen::Index number, Point& controlPoint) {
        controlPoint = point(Eigen::Vector3d(flat.row(number)));
    });
    return true;
}

} // namespace

void flatten(const Layout& layout, const SmoothNetwork& network, const std::vector<PatchSpace>& spaces,
             std::vector<std::optional<Plane>> planes, std::vector<Patch>& patches) {
    constexpr int attempts = 12;
    const auto isPlane = [](const auto& plane) { return plane.has_value(); };
    for (int k = 0; k < attempts && std::ranges::any_of(planes, isPlane); ++k)
        if (tryToFlatten(layout, network, spaces, planes, patches)) return;
}

} // namespace qm
