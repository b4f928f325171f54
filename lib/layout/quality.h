/// \file Figures that measure the quality of a layout (docs/METHOD.md#quality).
#pragma once

#include "layout/layout.h"

#include <cstddef>
#include <vector>

namespace qm {

/// The figures of a layout.
struct LayoutQuality {
    std::size_t segments = 0;
    std::size_t tJoints = 0;
    /// Share of the dihedral angles above rho that lies on the boundaries of segments, 0 to 1.
    double capturedSharpness = 0;
    double medianAspect = 0; ///< of the segments: longer to shorter side, in edges
    double maxAspect = 0;
};
[[nodiscard]] LayoutQuality measureLayout(const QuadMesh& mesh, const Layout& layout,
                                          const std::vector<double>& dihedralAngles, double rho);

} // namespace qm
