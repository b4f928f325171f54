/// \file The network of a layout's borders: stretches, and the runs along which surfaces are to be smooth.
#pragma once

#include "bspline/network/borders.h"
#include "bspline/network/smooth_run.h"
#include "bspline/network/stretches.h"
#include "bspline/network/vertex_rules.h"
#include "layout/layout.h"

#include <vector>

namespace qm {

struct SmoothNetwork {
    BorderMarks marks;
    std::vector<VertexRule> rules; ///< of all vertices
    std::vector<Stretch> stretches;
    std::vector<SmoothRun> runs; ///< their ratios have values at their ends, but no reach yet

    [[nodiscard]] Sharpness sharpness() const { return {rules, marks.isCrease}; }
};

/// Linear in the mesh.
/// \param dihedralAngles  by edge index, radians
/// \param rho  a border edge of a larger dihedral angle is a crease
[[nodiscard]] SmoothNetwork buildNetwork(const QuadMesh& mesh, const Layout& layout,
                                         const std::vector<double>& dihedralAngles, double rho);

} // namespace qm
