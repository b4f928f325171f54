#include "bspline/fit.h"

#include "base/error.h"
#include "base/parallel.h"
#include "bspline/deviation.h"
#include "bspline/interpolate.h"
#include "bspline/tolerance.h"
#include "bspline/watertight.h"

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

std::vector<Patch> fittedPatches(const QuadMesh& mesh, const Layout& layout,
                                 const std::vector<double>& dihedralAngles, const FitOptions& options,
                                 const Control& control) {
    if (options.fit == Fit::tolerance) {
        const double tolerance = options.tolerance.length(boundingBoxDiagonal(mesh));
        return fitWithinTolerance(mesh, layout, dihedralAngles, options.rho, tolerance, control.jobs);
    }
    if (options.watertight)
        return interpolateWatertight(mesh, layout, dihedralAngles, options.rho, control.jobs);
    return interpolateSegments(mesh, layout, control);
}

} // namespace

Surfaces fitSurfaces(const QuadMesh& mesh, const Layout& layout, const std::vector<double>& dihedralAngles,
                     const FitOptions& options, const Control& control) {
    requireValid(options);
    Surfaces surfaces;
    surfaces.patches = fittedPatches(mesh, layout, dihedralAngles, options, control);
    control.progress(0.5);
    auto measured = measureDeviation(mesh, layout, dihedralAngles, surfaces.patches,
                                     {options.rho, options.samplesPerEdge}, control);
    surfaces.deviation = measured.ofAll;
    surfaces.ofPatch = std::move(measured.ofPatch);
    control.progress(1);
    return surfaces;
}

} // namespace qm
