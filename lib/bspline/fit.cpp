#include "bspline/fit.h"

#include "base/error.h"
#include "base/parallel.h"
#include "bspline/fitting/smooth_fit.h"
#include "bspline/measure/measure.h"
#include "bspline/network/smooth_network.h"
#include "bspline/reference/limit_surface.h"
#include "bspline/splines/bounding_box.h"
#include "bspline/splines/interpolate.h"

#include <cmath>
#include <cstddef>
#include <locale>
#include <sstream>
#include <utility>

namespace qm {
namespace {

void requireValid(const FitOptions& options) {
    if (options.fit == Fit::smooth &&
        !(options.tolerance.value > 0 && std::isfinite(options.tolerance.value)))
        throw Error("tolerance", "must be a positive number", "Give the largest deviation that is allowed");
    if (!(options.rho >= 0)) throw Error("rho", "must not be negative", "Give an angle in radians");
}

std::vector<Patch> interpolateSegments(const QuadMesh& mesh, const Layout& layout, const Control& control) {
    std::vector<Patch> patches(layout.segments.size());
    parallelFor(patches.size(), control.jobs, [&](std::size_t k) {
        patches[k] = interpolate(pointGrid(mesh, layout.segments[k]), layout.segments[k].size);
        patches[k].segment = SegmentId(k);
    });
    return patches;
}

/// Steps of the reference's lattice along every mesh edge: fewer where edges are short anyway.
int latticeSteps(const QuadMesh& mesh) {
    constexpr std::size_t many = 300'000;
    return mesh.n_faces() > many ? 2 : 4;
}

} // namespace

Surfaces fitSurfaces(const QuadMesh& mesh, const Layout& layout, const std::vector<double>& dihedralAngles,
                     const FitOptions& options, const Control& control) {
    requireValid(options);
    const SmoothNetwork network = buildNetwork(mesh, layout, dihedralAngles, options.rho);
    const auto reference =
        limitSurface(mesh, layout, network.marks.isCrease, latticeSteps(mesh), control.jobs);
    Surfaces surfaces;
    if (options.fit == Fit::smooth) {
        const double tolerance = options.tolerance.length(boundingBoxDiagonal(mesh));
        // What lies between samples, and the width of the bound that is measured in the end.
        constexpr double share = 0.96;
        surfaces.patches =
            fitSmooth(mesh, layout, network, reference, {.tolerance = share * tolerance}, control);
    } else {
        surfaces.patches = interpolateSegments(mesh, layout, control);
    }
    std::vector<bool> isSmooth = network.marks.isCrease;
    isSmooth.flip();
    const Measurement measurement =
        measureSurfaces(mesh, layout, surfaces.patches, reference, isSmooth, {}, {}, control);
    surfaces.deviation = measurement.ofAll.deviation;
    surfaces.farthest = measurement.ofAll.farthest;
    for (const PatchMeasurement& ofPatch : measurement.ofPatch)
        surfaces.ofPatch.push_back(ofPatch.deviation);
    control.progress(1);
    return surfaces;
}

std::string missedTolerance(const Surfaces& surfaces, const FitOptions& options) {
    const Deviation& deviation = surfaces.deviation;
    if (options.fit != Fit::smooth || !(deviation.maxRelative > 0)) return {};
    const double tolerance = options.tolerance.length(deviation.max / deviation.maxRelative);
    if (deviation.max <= tolerance) return {};
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text.precision(3);
    text << "the tolerance is missed in patch " << surfaces.farthest.patch
         << " at u = " << surfaces.farthest.at[0] << ", v = " << surfaces.farthest.at[1] << ": "
         << deviation.max / tolerance
         << " times as far from the smooth surface through the vertices. Allow more, or mend the mesh there";
    return text.str();
}

} // namespace qm
