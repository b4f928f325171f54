#include "bspline/reference/fit_reference.h"

#include "bspline/reference/bridged_mesh.h"
#include "mesh/dihedral.h"

namespace qm {

FitReference fitReference(const QuadMesh& mesh, const Layout& layout,
                          const std::vector<double>& dihedralAngles, const ReferenceOptions& options,
                          const TriangleSurface* scan, unsigned jobs) {
    FitReference reference;
    reference.network = buildNetwork(mesh, layout, dihedralAngles, options.rho);
    if (options.bridges) reference.bridged = bridgedMesh(mesh, reference.network.marks.isCrease);
    if (reference.bridged)
        reference.network =
            buildNetwork(*reference.bridged, layout, qm::dihedralAngles(*reference.bridged), options.rho);
    const QuadMesh& upright = reference.bridged ? *reference.bridged : mesh;
    reference.target = fitTarget(upright, layout, reference.network, scan, jobs);
    return reference;
}

} // namespace qm
