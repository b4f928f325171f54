#include "bspline/fit.h"

#include "base/deadline.h"
#include "base/error.h"
#include "base/infinity.h"
#include "base/number_text.h"
#include "bspline/fitting/smooth_fit.h"
#include "bspline/measure/max_deviations.h"
#include "bspline/measure/measure.h"
#include "bspline/measure/scan_deviation.h"
#include "bspline/network/crease_paths.h"
#include "bspline/reference/fit_reference.h"
#include "bspline/reference/planes/plane.h"
#include "bspline/splines/interpolate.h"
#include "mesh/bounding_box.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

namespace qm {
namespace {

void requireValid(const FitOptions& options) {
    if (options.fit == Fit::smooth &&
        !(options.tolerance.value > 0 && std::isfinite(options.tolerance.value)))
        throw Error("tolerance", "must be a positive number", "Give the largest deviation that is allowed");
    if (!(options.rho >= 0)) throw Error("rho", "must not be negative", "Give an angle in radians");
}

/// Meshes of more faces are large.
constexpr std::size_t manyFaces = 30'000;

/// How finely meshes are sampled, and how long their fit may take. Large ones are sampled less finely, as
/// their edges are short, and are fitted in time linear in their size. There are four lattice steps between
/// any two knots whatever the mesh.
SmoothFitOptions effortFor(const QuadMesh& mesh) {
    constexpr std::size_t several = 8'000;
    SmoothFitOptions options;
    if (mesh.n_faces() > several) {
        options.steps = 2;
        options.unfoldings = 3;
    }
    if (mesh.n_faces() <= manyFaces) return options;
    const bool areVeryMany = mesh.n_faces() > veryManyFaces;
    if (areVeryMany) options.steps = 1;
    options.minInterval = 2; // with edges as short, knots between would follow nothing but errors of the fit
    options.unfoldings = 0;  // beginning anew can take seconds
    options.evenBorders = 0.5; // there are few rounds to shorten what is too long at first
    options.maxRounds = 20;
    options.maxIdle = 4;
    options.roundsOfMending = 4;
    options.slides = areVeryMany ? 2 : 3;
    options.verifications = 4;
    options.slack = 0; // lest it lead astray
    options.ringsAround = 1;
    options.worthAll = 0.8;
    options.removesKnots = false;
    return options;
}

/// A fit of a large mesh that is farther off than this, in tolerances, is made once more with the patience
/// that small ones get: few meshes need it, such as plates around holes.
constexpr double farOff = 1.2;

SmoothFitOptions withPatience(SmoothFitOptions effort) {
    const SmoothFitOptions patient;
    effort.unfoldings = patient.unfoldings;
    effort.maxRounds = patient.maxRounds;
    effort.maxIdle = patient.maxIdle;
    effort.slides = patient.slides;
    effort.restarts = false; // they have not helped
    return effort;
}

/// The slack of fits to scans, in tolerances: noise that is left takes more of it.
constexpr double slackInNoise = 0.5;

/// Share of the tolerance that is used at the lattice's points: the rest is for what lies between.
constexpr double shareAtPoints = 0.97;

/// How far a reference may be from a plane that it is taken for: a share of what is allowed.
constexpr double planeShare = 0.005;

/// Multiple of a scan's noise that its smoothing leaves at worst.
constexpr double noiseLeft = 1.5;

/// What is measured is larger by so much: distances up to this are found to be allowed.
double certifiable(double allowed) {
    return allowed / (1 + measureClosing);
}

/// The fit within a tolerance, verified by certified measurements.
std::vector<Patch> smoothPatches(const QuadMesh& mesh, const Layout& layout, const FitReference& reference,
                                 double allowed, const Control& control) {
    const double limit = certifiable(allowed);
    MaxDeviations maxDeviations(mesh, layout, reference.target.grids, limit, control.jobs);
    const Verification verify = [&](const std::vector<Patch>& patches) {
        std::vector<double> found = maxDeviations(patches);
        for (double& distance : found)
            distance /= limit;
        return found;
    };
    SmoothFitOptions effort = effortFor(mesh);
    effort.tolerance = shareAtPoints * allowed;
    if (reference.target.noise > 0 && effort.slack > 0) effort.slack = slackInNoise;
    effort.flatness = std::min(planeShare * allowed, maxFlatness * boundingBox(mesh).diagonal());
    const QuadMesh& upright = reference.meshOf(mesh);
    if (mesh.n_faces() <= manyFaces)
        return fitSmooth({upright, layout, reference.network, reference.target, verify}, effort, control);

    double nearest = infinity; // of what was verified, in tolerances
    const Verification noted = [&](const std::vector<Patch>& patches) {
        auto found = verify(patches);
        nearest = std::min(nearest, std::ranges::max(found));
        return found;
    };
    const FitProblem problem{upright, layout, reference.network, reference.target, noted};
    std::vector<Patch> patches = fitSmooth(problem, effort, control);
    if (nearest <= farOff || control.stopRequested()) return patches;
    const double before = std::exchange(nearest, infinity);
    std::vector<Patch> better = fitSmooth(problem, withPatience(effort), control);
    return nearest < before ? better : patches;
}

void addMeasurement(const Measurement& measurement, Surfaces& surfaces) {
    surfaces.deviation = measurement.ofAll.deviation;
    surfaces.farthest = measurement.ofAll.farthest;
    for (std::size_t patch = 0; patch < measurement.ofPatch.size(); ++patch) {
        surfaces.ofPatch.push_back(measurement.ofPatch[patch].deviation);
        for (const auto& place : measurement.ofPatch[patch].folds)
            surfaces.folds.push_back({patch, place});
    }
}

} // namespace

Surfaces fitSurfaces(const QuadMesh& mesh, const Layout& layout, const std::vector<double>& dihedralAngles,
                     const FitOptions& options, const TriangleSurface* scan, const Control& control) {
    requireValid(options);
    const Deadline end(control, options.timeLimit);
    Control limited = end.control();
    limited.progress = control.progress;
    const bool isSmoothFit = options.fit == Fit::smooth;
    const FitReference reference = fitReference(
        mesh, layout, dihedralAngles, {.rho = options.rho, .improves = isSmoothFit}, scan, control.jobs);
    const BorderMarks& marks = reference.network.marks;
    const FitTarget& target = reference.target;
    const double diagonal = boundingBox(mesh).diagonal();
    const double allowed = options.tolerance.length(diagonal) + noiseLeft * target.noise;
    Surfaces surfaces;
    surfaces.patches = isSmoothFit ? smoothPatches(mesh, layout, reference, allowed, limited)
                                   : interpolateSegments(mesh, layout, control.jobs);
    surfaces.endedEarly = isSmoothFit && end.isOver();
    surfaces.creases = creasePaths(mesh, marks);
    std::vector<bool> isSmooth = marks.isCrease;
    isSmooth.flip();
    const double negligible = std::min(measureNegligible * diagonal, certifiable(allowed));
    addMeasurement(
        measureSurfaces({mesh, layout, surfaces.patches, target.grids}, isSmooth, negligible, control.jobs),
        surfaces);
    if (scan != nullptr)
        surfaces.scan = {deviationFromScan(surfaces.patches, *scan, target.maxDistance,
                                           {.negligible = negligible}, control.jobs),
                         target.coverage, target.noise};
    control.progress(1);
    return surfaces;
}

double allowedDistance(const Surfaces& surfaces, const FitOptions& options, double diagonal) {
    return options.tolerance.length(diagonal) + (surfaces.scan ? noiseLeft * surfaces.scan->noise : 0);
}

std::string missedTolerance(const Surfaces& surfaces, const FitOptions& options) {
    const Deviation& deviation = surfaces.deviation;
    if (options.fit != Fit::smooth || !(deviation.maxRelative > 0)) return {};
    const double tolerance = allowedDistance(surfaces, options, deviation.max / deviation.maxRelative);
    if (deviation.max <= tolerance) return {};
    const auto rounded = [](double value) { return roundedText(value, 4); };
    const auto& [patch, at] = surfaces.farthest;
    return "the tolerance is missed in patch " + std::to_string(patch) + " at u = " + rounded(at[0]) +
           ", v = " + rounded(at[1]) + ": " + rounded(deviation.max / tolerance) + " times as far from the " +
           (surfaces.scan ? "scan" : "smooth surface through the vertices") +
           ". Allow more, or mend the mesh there";
}

} // namespace qm
