#include "support/cheapest_layout.h"

#include "basecomplex/base_complex.h"
#include "enumerate/enumerate.h"
#include "mesh/dihedral.h"

#include <vector>

namespace qm::test {

Layout cheapestLayout(const QuadMesh& mesh) {
    const std::vector<double> angles = dihedralAngles(mesh);
    const Enumeration found = enumerateGraphs({mesh, buildBaseComplex(mesh), angles, {}, {}}, {});
    return buildLayout(mesh, found.subMeshes.front().graphs.at(0).tracks, angles, edgeCosts(angles, {}));
}

} // namespace qm::test
