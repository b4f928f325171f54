#include "bspline/fit.h"

#include "base/error.h"
#include "base/parallel.h"
#include "bspline/deviation.h"
#include "bspline/interpolate.h"
#include "bspline/tolerance.h"
#include "bspline/watertight.h"

#include <algorithm>
#include <cmath>

namespace qm {
namespace {

void requireValid(const FitOptions& options) {
    if (options.fit == Fit::tolerance &&
        !(options.tolerance.value > 0 && std::isfinite(options.tolerance.value)))
        throw Error("tolerance", "must be a positive number", "Give the largest deviation that is allowed");
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

/// Patches and how far they are from the mesh.
Surfaces measured(const QuadMesh& mesh, const Layout& layout, const std::vector<double>& dihedralAngles,
                  std::vector<Patch> patches, const FitOptions& options, const Control& control) {
    auto deviation = measureDeviation(mesh, layout, dihedralAngles, patches,
                                      {options.rho, options.samplesPerEdge}, control);
    return {std::move(patches), deviation.ofAll, std::move(deviation.ofPatch)};
}

/// A patch that turns away from its quads misses the tolerance, however close to them it is.
double asMiss(const Deviation& deviation, double tolerance) {
    constexpr double mostBent = 30; // degrees
    constexpr double excess = 1.5;
    const bool bent = deviation.largestNormalDeviation > mostBent;
    return bent ? std::max(deviation.max, excess * tolerance) : deviation.max;
}

Surfaces fitWithinTolerance(const QuadMesh& mesh, const Layout& layout,
                            const std::vector<double>& dihedralAngles, const FitOptions& options,
                            const Control& control) {
    const double tolerance = options.tolerance.length(boundingBoxDiagonal(mesh));
    ToleranceFit fit(mesh, layout, dihedralAngles, options.rho, tolerance, control.jobs);
    constexpr int enough = 10;  // by then the fit is certain of the tolerance
    constexpr int hopeless = 4; // folded quads have folded patches
    for (int round = 0;; ++round) {
        control.progress(0.5);
        Surfaces surfaces = measured(mesh, layout, dihedralAngles, fit.patches(), options, control);
        std::vector<double> deviations;
        for (const Deviation& deviation : surfaces.ofPatch)
            deviations.push_back(round < hopeless ? asMiss(deviation, tolerance) : deviation.max);
        const bool close = std::ranges::all_of(deviations, [&](double d) { return d <= tolerance; });
        if (close || round == enough) return surfaces;
        fit.tighten(deviations);
    }
}

} // namespace

Surfaces fitSurfaces(const QuadMesh& mesh, const Layout& layout, const std::vector<double>& dihedralAngles,
                     const FitOptions& options, const Control& control) {
    requireValid(options);
    Surfaces surfaces =
        options.fit == Fit::tolerance
            ? fitWithinTolerance(mesh, layout, dihedralAngles, options, control)
            : measured(mesh, layout, dihedralAngles,
                       interpolatedPatches(mesh, layout, dihedralAngles, options, control), options, control);
    control.progress(1);
    return surfaces;
}

} // namespace qm
