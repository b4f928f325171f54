// The network of a layout, with creases as sharp as for most tests.
#pragma once

#include "bspline/network/smooth_network.h"
#include "mesh/dihedral.h"

namespace qm::test {

inline SmoothNetwork networkOf(const QuadMesh& mesh, const Layout& layout) {
    return buildNetwork(mesh, layout, dihedralAngles(mesh), 0.45);
}

} // namespace qm::test
