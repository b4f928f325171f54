#include "bspline/reference/fit_target.h"

#include "base/error.h"
#include "bspline/reference/limit_surface.h"
#include "bspline/reference/scan_reference.h"

#include <string>

namespace qm {

FitTarget fitTarget(const QuadMesh& mesh, const Layout& layout, const SmoothNetwork& network,
                    const TriangleSurface* scan, unsigned jobs) {
    const int steps = mesh.n_faces() > veryManyFaces ? 2 : 4;
    FitTarget target;
    target.grids = limitSurface(mesh, layout, network.rules, network.marks.isCrease, steps, jobs);
    if (scan == nullptr) return target;
    FitTarget found = scanReference(mesh, layout, target.grids, *scan, jobs);
    constexpr double minCoverage = 0.1; // with less it is another part, or lies elsewhere
    if (found.coverage < minCoverage)
        throw Error("reference",
                    "only " + std::to_string(static_cast<int>(100 * found.coverage)) +
                        " per cent of the mesh are near the scan",
                    "Give a scan of the same part, in the same place and unit");
    return found;
}

} // namespace qm
