#include "bspline/fitting/lattice/lattice_errors.h"

#include "bspline/fitting/lattice/lattice_holds.h"
#include "bspline/splines/evaluate.h"

#include <algorithm>
#include <cmath>

namespace qm {
namespace {

/// A patch counts as folded where its Jacobian is less than this share of the reference's.
constexpr double minJacobian = 0.1;
/// The same at creases and corners, where the sides of a patch may be more nearly parallel.
constexpr double minJacobianAtSides = 0.01;

std::vector<SurfacePoint> pointsOf(const Patch& patch, const FitLattice& lattice) {
    return evaluateLattice(patch, lattice.targets.parameters[0], lattice.targets.parameters[1]);
}

bool isFolded(const FitLattice& lattice, std::size_t k, const SurfacePoint& point) {
    const double min = lattice.freedom[k] == Freedom::surface ? minJacobian : minJacobianAtSides;
    return ((point.du % point.dv) | lattice.normals[k]) < min * lattice.jacobian[k];
}

/// The mean of both normals. Where a surface has slid along a bend this is the direction to measure the
/// distance in, because the chord between two points of a parabola is perpendicular to it. Zero where the
/// normals differ too much.
Point meanNormal(const FitLattice& lattice, std::size_t k, const SurfacePoint& point) {
    const Point sum = lattice.axes[k] + point.normal();
    const double length = sum.norm();
    return length > 1 ? sum / length : Point(0, 0, 0);
}

/// The same for the direction of a crease: the distance is perpendicular to the mean of both directions.
Point meanDirection(const FitLattice& lattice, std::size_t k, const SurfacePoint& point) {
    const Point& axis = lattice.axes[k];
    const Point u = unit(point.du);
    const Point v = unit(point.dv);
    const Point& along = std::abs(u | axis) > std::abs(v | axis) ? u : v;
    return unit(axis + ((along | axis) < 0 ? -along : along));
}

/// Either of them, as the point's freedom is; zero at corners.
Point meanAxis(const FitLattice& lattice, std::size_t k, const SurfacePoint& point) {
    switch (lattice.freedom[k]) {
    case Freedom::surface:
        return meanNormal(lattice, k, point);
    case Freedom::crease:
        return meanDirection(lattice, k, point);
    default:
        return {0, 0, 0};
    }
}

double signedDistance(const FitLattice& lattice, std::size_t k, const SurfacePoint& point,
                      const Point& offset) {
    // Where the surface turns away from the reference, the offset is only an upper bound of the distance.
    constexpr double turnedAway = 0.87; // cosine of half of 60 degrees
    const Point mean = meanAxis(lattice, k, point);
    switch (lattice.freedom[k]) {
    case Freedom::surface:
        return (lattice.axes[k] | mean) < turnedAway ? offset.norm() : (offset | mean);
    case Freedom::crease:
        return (offset - mean * (offset | mean)).norm();
    default:
        return offset.norm();
    }
}

/// Targets slide only where the normals of surface and reference agree up to this: the cosine of half their
/// angle.
constexpr double minCosine = 0.92;

/// By point: the mean axis, or zero where no target slides.
std::vector<Point> meanAxes(const FitLattice& lattice, const std::vector<SurfacePoint>& points) {
    std::vector<Point> axes(points.size(), Point(0, 0, 0));
    for (std::size_t k = 0; k < points.size(); ++k)
        if (!lattice.isHeld[k]) axes[k] = meanAxis(lattice, k, points[k]);
    return axes;
}

/// The weighted mean distance of a patch from the reference.
double meanDistance(const FitLattice& lattice, const std::vector<SurfacePoint>& points,
                    const std::vector<Point>& axes) {
    double sum = 0;
    double weights = 0;
    for (std::size_t k = 0; k < points.size(); ++k) {
        if (lattice.isHeld[k] || lattice.freedom[k] != Freedom::surface) continue;
        if ((lattice.axes[k] | axes[k]) < minCosine) continue;
        const double weight = lattice.targets.weights[k] / lattice.emphasis[k];
        sum += weight * ((points[k].position - lattice.reference[k]) | axes[k]);
        weights += weight;
    }
    return weights > 0 ? sum / weights : 0;
}

struct SlideLimits {
    double edges = 1; ///< the largest slide along the reference, in the reference's edges
    double mean = 0;  ///< distance of the patch from the reference, from which slides along the normal count
    double slack = 0; ///< the largest slide along the normal
};

/// From the reference's point: where a target is to be, and where it goes in the direction in which it moves.
struct Slide {
    Point slide{0, 0, 0};
    Point ahead{0, 0, 0};
};

/// \param position  of the surface
/// \param axis      of `meanAxes`
Slide slideOf(const FitLattice& lattice, std::size_t k, const Point& position, const Point& axis,
              const SlideLimits& limits) {
    // Enough for slides to converge in a few steps, but not so much that they oscillate.
    constexpr double momentum = 0.8;
    // Draws targets back to the reference's parameters where nothing else determines them.
    constexpr double anchor = 0.01;
    // The same along the normal: waves are much stiffer than this, the shapes of whole parts much softer.
    constexpr double restoring = 0.15;
    const bool onCrease = lattice.freedom[k] == Freedom::crease;
    if (!((lattice.axes[k] | axis) >= minCosine)) return {};
    const auto allowed = [&](const Point& vector) {
        const Point along = axis * (vector | axis);
        return onCrease ? along : vector - along;
    };
    const Point offset = position - lattice.reference[k];
    Point slide = (1 - anchor) * allowed(offset);
    const double limit = limits.edges * lattice.edge[k];
    const double length = slide.norm();
    if (length > limit) slide *= limit / length;
    Point ahead = slide + momentum * allowed(slide - lattice.slides[k]);
    if (onCrease) return {slide, ahead};
    const double ofPoint = limits.slack / lattice.emphasis[k];
    const auto within = [&](double distance) { return std::clamp(distance, -ofPoint, ofPoint); };
    const double distance = within((1 - restoring) * ((offset | axis) - limits.mean));
    const double change = distance - (lattice.slides[k] | axis);
    slide += distance * axis;
    ahead += within(distance + momentum * change) * axis;
    return {slide, ahead};
}

} // namespace

double PatchErrors::max() const {
    return std::ranges::max(error);
}

double PatchErrors::maxDistance() const {
    double max = 0;
    for (const double distance : signedDistance)
        max = std::max(max, std::abs(distance));
    return max;
}

bool PatchErrors::anyFolded() const {
    return std::ranges::find(isFolded, true) != isFolded.end();
}

double distance(const FitLattice& lattice, std::size_t point, const Point& offset) {
    const Point& axis = lattice.axes[point];
    switch (lattice.freedom[point]) {
    case Freedom::surface:
        return axis.sqrnorm() > 0 ? std::abs(offset | axis) : offset.norm();
    case Freedom::crease:
        return (offset - axis * (offset | axis)).norm();
    default:
        return offset.norm();
    }
}

PatchErrors latticeErrors(const FitLattice& lattice, const Patch& patch, double tolerance, double scale) {
    constexpr double ofFolds = 2;
    const auto points = pointsOf(patch, lattice);
    PatchErrors errors;
    errors.signedDistance.reserve(points.size());
    errors.error.reserve(points.size());
    errors.isFolded.reserve(points.size());
    for (std::size_t k = 0; k < points.size(); ++k) {
        const Point offset = points[k].position - lattice.reference[k];
        errors.signedDistance.push_back(scale * signedDistance(lattice, k, points[k], offset) / tolerance);
        const double size = std::abs(errors.signedDistance.back());
        errors.isFolded.push_back(isFolded(lattice, k, points[k]));
        errors.error.push_back(errors.isFolded.back() ? std::max(ofFolds, size) : size);
    }
    return errors;
}

void slideTargets(const Patch& patch, double slack, FitLattice& lattice) {
    // Targets slide by one edge at most, or by this share of the patch's shorter side: where the mesh's lines
    // turn all at once, such as around a hole in a plate, it takes the more of its edges to turn gently the
    // finer the mesh is.
    constexpr double slideShare = 0.25;
    const auto& parameters = lattice.targets.parameters;
    const auto points = pointsOf(patch, lattice);
    std::vector<bool> areFolded(points.size());
    for (std::size_t k = 0; k < points.size(); ++k)
        areFolded[k] = isFolded(lattice, k, points[k]);
    holdAroundFolds(areFolded, lattice);
    const std::vector<Point> axes = meanAxes(lattice, points);
    const SlideLimits limits{
        .edges = std::max(1.0, slideShare * std::min(parameters[0].back(), parameters[1].back())),
        .mean = slack > 0 ? meanDistance(lattice, points, axes) : 0,
        .slack = slack};
    for (std::size_t k = 0; k < points.size(); ++k) {
        if (lattice.isHeld[k] || lattice.freedom[k] == Freedom::corner) continue;
        const auto [slide, ahead] = slideOf(lattice, k, points[k].position, axes[k], limits);
        lattice.slides[k] = slide;
        lattice.targets.points[k] = lattice.reference[k] + ahead;
    }
}

} // namespace qm
