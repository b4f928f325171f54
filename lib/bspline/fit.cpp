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

Surfaces withDeviation(std::vector<Patch> patches, MeasuredDeviation deviation) {
    return {std::move(patches), deviation.ofAll, std::move(deviation.ofPatch)};
}

Surfaces fitWithinTolerance(const QuadMesh& mesh, const Layout& layout,
                            const std::vector<double>& dihedralAngles, const FitOptions& options,
                            const Control& control) {
    const double tolerance = options.tolerance.length(boundingBoxDiagonal(mesh));
    constexpr double mostBent = 30;   // degrees that a patch may turn away from its quads,
    constexpr double mostKinked = 45; // and from its neighbour
    constexpr int enough = 10;        // by then the fit is certain of the tolerance
    constexpr int hopeless = 4;       // folded quads have folded patches
    DeviationOptions measure{options.rho, options.samplesPerEdge, tolerance, mostBent, mostKinked};
    ToleranceFit fit(mesh, layout, dihedralAngles, options.rho, tolerance, control.jobs);
    for (int round = 0;; ++round) {
        control.progress(0.5);
        if (round == hopeless) measure.mostBent = measure.mostKinked = 180;
        auto deviation = measureDeviation(mesh, layout, dihedralAngles, fit.patches(), measure, control);
        const bool close = std::ranges::all_of(deviation.places, [](const auto& p) { return p.empty(); });
        if (close || round == enough) {
            if (!measure.only.empty()) {
                measure.only.clear();
                deviation = measureDeviation(mesh, layout, dihedralAngles, fit.patches(), measure, control);
            }
            control.progress(1);
            return withDeviation(fit.patches(), std::move(deviation));
        }
        measure.only = fit.tighten(deviation.places);
        for (std::size_t k = 0; k < measure.only.size(); ++k)
            measure.only[k] = measure.only[k] || !deviation.places[k].empty();
    }
}

} // namespace

Surfaces fitSurfaces(const QuadMesh& mesh, const Layout& layout, const std::vector<double>& dihedralAngles,
                     const FitOptions& options, const Control& control) {
    requireValid(options);
    if (options.fit == Fit::tolerance)
        return fitWithinTolerance(mesh, layout, dihedralAngles, options, control);
    auto patches = interpolatedPatches(mesh, layout, dihedralAngles, options, control);
    auto deviation = measureDeviation(mesh, layout, dihedralAngles, patches,
                                      {options.rho, options.samplesPerEdge}, control);
    control.progress(1);
    return withDeviation(std::move(patches), std::move(deviation));
}

} // namespace qm
