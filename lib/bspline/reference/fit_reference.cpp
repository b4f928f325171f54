#include "bspline/reference/fit_reference.h"

#include "base/error.h"
#include "bspline/reference/improvement/bridged_mesh.h"
#include "bspline/reference/improvement/evened_mesh.h"
#include "bspline/reference/limit/limit_surface.h"
#include "bspline/reference/planes/plane.h"
#include "bspline/reference/scan/scan_reference.h"
#include "mesh/bounding_box.h"
#include "mesh/dihedral.h"

#include <string>
#include <utility>

namespace qm {
namespace {

FitTarget fitTarget(const QuadMesh& mesh, const Layout& layout, const SmoothNetwork& network,
                    const TriangleSurface* scan, unsigned jobs) {
    const int steps = mesh.n_faces() > veryManyFaces ? 2 : 4;
    FitTarget target;
    target.grids = limitSurface(mesh, layout, network.sharpness(), steps, jobs);
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

/// Replaces the mesh and its network by better ones, if vertices are to move.
void improve(const QuadMesh& mesh, const Layout& layout, double rho, unsigned jobs, FitReference& reference) {
    const auto replace = [&](std::optional<QuadMesh> better) {
        if (!better) return;
        reference.improved = std::move(better);
        reference.network =
            buildNetwork(*reference.improved, layout, qm::dihedralAngles(*reference.improved), rho);
    };
    replace(bridgedMesh(mesh, reference.network.marks.isCrease));
    const double flatness = maxFlatness * boundingBox(mesh).diagonal();
    replace(evenedMesh(reference.meshOf(mesh), reference.network.marks.isCrease, flatness, jobs));
}

} // namespace

FitReference fitReference(const QuadMesh& mesh, const Layout& layout,
                          const std::vector<double>& dihedralAngles, const ReferenceOptions& options,
                          const TriangleSurface* scan, unsigned jobs) {
    FitReference reference;
    reference.network = buildNetwork(mesh, layout, dihedralAngles, options.rho);
    if (options.improves) improve(mesh, layout, options.rho, jobs, reference);
    reference.target = fitTarget(reference.meshOf(mesh), layout, reference.network, scan, jobs);
    return reference;
}

} // namespace qm
