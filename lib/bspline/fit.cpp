#include "bspline/fit.h"

#include "base/error.h"
#include "base/parallel.h"
#include "bspline/deviation.h"
#include "bspline/interpolate.h"
#include "bspline/kink_reduction.h"
#include "bspline/tolerance.h"
#include "bspline/watertight.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace qm {
namespace {

void requireValid(const FitOptions& options) {
    if (options.fit == Fit::tolerance &&
        !(options.tolerance.value > 0 && std::isfinite(options.tolerance.value)))
        throw Error("tolerance", "must be a positive number", "Give the largest deviation that is allowed");
    if (!(options.maxKink >= 0)) throw Error("kink", "must not be negative", "Give an angle in degrees");
    if (!(options.kinkBudget >= 0 && options.kinkBudget <= 10))
        throw Error("kink budget", "must be from 0 to 10", "Give a share of interpolation's control points");
    if (!(options.rho >= 0)) throw Error("rho", "must not be negative", "Give an angle in radians");
    if (options.samplesPerEdge < 1 || options.samplesPerEdge > 100)
        throw Error("samples per edge", "must be from 1 to 100", "2 is a good choice");
}

std::vector<Patch> interpolateSegments(const QuadMesh& mesh, const Layout& layout, const Control& control) {
    std::vector<Patch> patches(layout.segments.size());
    parallelFor(patches.size(), control.jobs, [&](std::size_t k) {
        patches[k] = interpolate(pointGrid(mesh, layout.segments[k]), layout.segments[k].size);
        patches[k].segment = SegmentId(k);
    });
    return patches;
}

std::vector<Patch> interpolatedPatches(const QuadMesh& mesh, const Layout& layout,
                                       const std::vector<double>& dihedralAngles, const FitOptions& options,
                                       const Control& control) {
    if (options.watertight)
        return interpolateWatertight(mesh, layout, dihedralAngles, options.rho, control.jobs);
    return interpolateSegments(mesh, layout, control);
}

Surfaces withDeviation(std::vector<Patch> patches, MeasuredDeviation deviation) {
    return {std::move(patches), deviation.ofAll, std::move(deviation.ofPatch)};
}

bool isEmpty(const DeviatingPlaces& places) {
    return std::ranges::all_of(places, [](const auto& ofPatch) { return ofPatch.empty(); });
}

/// Fits closer until nothing is beyond the limits. Those of the normals are given up where they cannot be
/// kept: folded quads have folded patches.
void keepLimits(ToleranceFit& fit, const DeviationMeter& meter, DeviationLimits limits,
                const Control& control) {
    constexpr int enough = 10; // by then the fit is certain of the tolerance
    constexpr int hopeless = 6;
    std::vector<bool> only;
    for (int round = 0; round < enough; ++round) {
        control.progress(0.5 * round / enough);
        if (round == hopeless) limits = {limits.farthest};
        const DeviatingPlaces places = meter.find(fit.patches(), limits, only, control);
        if (isEmpty(places)) return;
        only = fit.tighten(places);
        for (std::size_t k = 0; k < only.size(); ++k)
            only[k] = only[k] || !places[k].empty();
    }
}

std::size_t interpolatedPoints(const Layout& layout) {
    std::size_t points = 0;
    for (const Segment& segment : layout.segments)
        points +=
            static_cast<std::size_t>(segment.size[0] + 3) * static_cast<std::size_t>(segment.size[1] + 3);
    return points;
}

/// How near curves come to the planes in which they should meet, as sines; no patch can mend what they miss.
/// The first is taken that takes no more than a share of the control points that smooth borders may have.
constexpr std::array<double, 3> tangencies = {0.02, 0.05, 0.15};

Surfaces fitWithinTolerance(const QuadMesh& mesh, const Layout& layout,
                            const std::vector<double>& dihedralAngles, const FitOptions& options,
                            const DeviationMeter& meter, const Control& control) {
    const double tolerance = options.tolerance.length(meter.diagonal());
    constexpr double mostBent = 30;   // degrees that a patch may turn away from its quads,
    constexpr double mostKinked = 45; // and from its neighbour
    const DeviationLimits limits{tolerance, mostBent, mostKinked};
    const double most = options.kinkBudget * static_cast<double>(interpolatedPoints(layout));
    const KinkLimits kinks{options.maxKink, static_cast<std::size_t>(most)};
    constexpr double forCurves = 0.85;
    std::optional<ToleranceFit> fit;
    for (const double tangency : tangencies) {
        const bool isLast = tangency == tangencies.back();
        if (!isLast && !(kinks.angle < 180)) continue; // no kink is too large
        const std::size_t mostPoints =
            isLast ? std::numeric_limits<std::size_t>::max() : static_cast<std::size_t>(forCurves * most);
        fit.emplace(mesh, layout, dihedralAngles, options.rho, tolerance, tangency, mostPoints, control.jobs);
        if (fit->isComplete()) break;
    }
    keepLimits(*fit, meter, limits, control);
    reduceKinks(mesh, layout, *fit, kinks, meter, limits, control);
    return withDeviation(fit->patches(), meter.measure(fit->patches(), control));
}

} // namespace

Surfaces fitSurfaces(const QuadMesh& mesh, const Layout& layout, const std::vector<double>& dihedralAngles,
                     const FitOptions& options, const Control& control) {
    requireValid(options);
    const DeviationMeter meter(mesh, layout, dihedralAngles, {options.rho, options.samplesPerEdge});
    Surfaces surfaces;
    if (options.fit == Fit::tolerance) {
        surfaces = fitWithinTolerance(mesh, layout, dihedralAngles, options, meter, control);
    } else {
        auto patches = interpolatedPatches(mesh, layout, dihedralAngles, options, control);
        auto deviation = meter.measure(patches, control);
        surfaces = withDeviation(std::move(patches), std::move(deviation));
    }
    control.progress(1);
    return surfaces;
}

} // namespace qm
