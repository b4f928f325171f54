/// \file How good a layout is (docs/METHOD.md#quality).
#pragma once

#include "layout/layout.h"

#include <cstddef>
#include <vector>

namespace qm {

/// Figures that say how good a layout is.
struct LayoutQuality {
    std::size_t segments = 0;
    std::size_t tJoints = 0;
    double capturedSharpness =
        0; ///< share of the dihedral angle above rho that lies on segment boundaries, 0 to 1
    double medianAspect = 0; ///< of the segments' longer to shorter side, in edges
    double maxAspect = 0;
};
[[nodiscard]] LayoutQuality measureLayout(const QuadMesh& mesh, const Layout& layout,
                                          const std::vector<double>& dihedralAngles, double rho);

} // namespace qm
