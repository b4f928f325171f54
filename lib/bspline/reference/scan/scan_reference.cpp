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

#include <utility>

namespace qm {

FitTarget scanReference(const QuadMesh& mesh, const Layout& layout, const std::vector<ReferenceGrid>& surface,
                        const TriangleSurface& scan, unsigned jobs, double maxDistance) {
    if (surface.empty()) return {.coverage = 0};
    const LatticeNormals lattice = latticeNormals(mesh, layout, surface, jobs);
    const double edge = meanEdgeLength(mesh);
    const double step = edge / surface.front().steps;
    const ScanReach reach = maxDistance > 0 ? ScanReach{maxDistance, maxDistance} : ScanReach{step, 2 * edge};
    ScanProjection projection = projectOntoScan(lattice, scan, reach, jobs);
    ScanTargets targets(lattice, surface, std::move(projection.displacements));
    const double negligible = step / 40; // as a difference between neighbours: no sign of an outlier
    weighOutliers(targets, negligible);
    const double coverage = targets.coverage();
    FitTarget result = targets.result();
    fillGaps(lattice, surface, Gaps::butForSharpOnes, result);
    smoothInside(result, jobs);
    targets.update(result);
    extrapolateToSharpEdges(targets, scan, projection.maxDistance, step / 4);
    dropSharpOutliers(targets, negligible);
    result = targets.result();
    result.coverage = coverage;
    result.maxDistance = projection.maxDistance;
    dropFolded(lattice, surface, result);
    fillGaps(lattice, surface, Gaps::all, result);
    smoothBorders(result, jobs);
    return result;
}

} // namespace qm
