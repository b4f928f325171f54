#include "bspline/reference/scan/scan_reference.h"

#include "bspline/reference/lattice/lattice_normals.h"
#include "bspline/reference/scan/scan_folds.h"
#include "bspline/reference/scan/scan_gaps.h"
#include "bspline/reference/scan/scan_outliers.h"
#include "bspline/reference/scan/scan_projection.h"
#include "bspline/reference/scan/scan_sharp_edges.h"
#include "bspline/reference/scan/scan_smoothing.h"
#include "bspline/reference/scan/scan_targets.h"
#include "mesh/quad_geometry.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace qm {
namespace {

/// Of the triangles: of many of them, if there are very many.
double meanEdgeLength(const TriangleSurface& scan) {
    constexpr std::size_t enough = 10'000;
    const std::size_t stride = 1 + scan.size() / enough;
    double sum = 0;
    double count = 0;
    for (std::size_t face = 0; face < scan.size(); face += stride) {
        const auto [a, b, c] = scan.corners(face);
        sum += (b - a).norm() + (c - b).norm() + (a - c).norm();
        count += 3;
    }
    return sum / count;
}

} // namespace

FitTarget scanReference(const QuadMesh& mesh, const Layout& layout, const std::vector<ReferenceGrid>& surface,
                        const TriangleSurface& scan, unsigned jobs) {
    if (surface.empty()) return {.coverage = 0};
    const LatticeNormals lattice = latticeNormals(mesh, layout, surface, jobs);
    const double edge = meanEdgeLength(mesh);
    const double step = edge / surface.front().steps;
    ScanProjection projection = projectOntoScan(lattice, scan, {.min = step, .max = 2 * edge}, jobs);
    ScanTargets targets(lattice, surface, std::move(projection.displacements));
    targets.grain = meanEdgeLength(scan) / step;
    const double grain = std::max(1.0, targets.grain);
    // Within a triangle the noise of its corners is averaged.
    const auto ofVertices = scan.noise();
    targets.noise = ofVertices ? std::sqrt(0.5) * *ofVertices : noiseOfTargets(targets);
    const double negligible = step / 40; // as a difference between neighbours: no sign of an outlier
    weighOutliers(targets, negligible);
    const double coverage = targets.coverage();
    FitTarget result = targets.result();
    fillGaps(lattice, surface, Gaps::butForSharpOnes, result);
    smoothInside(result, grain, jobs);
    targets.update(result);
    extrapolateToSharpEdges(targets, scan, projection.maxDistance, step / 4);
    dropSharpOutliers(targets, negligible);
    result = targets.result();
    result.coverage = coverage;
    result.maxDistance = projection.maxDistance;
    dropFolded(lattice, surface, result);
    fillGaps(lattice, surface, Gaps::all, result);
    smoothBorders(result, grain, jobs);
    return result;
}

} // namespace qm
