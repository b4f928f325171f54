/// \file The quadratic form that a patch minimises: weighted squared distances from points, and bending
/// energy.
#pragma once

#include "bspline/fitting/energy/thin_plate.h"
#include "bspline/splines/basis.h"
#include "bspline/splines/patch_space.h"
#include "mesh/quad_mesh.h"

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <array>
#include <vector>

namespace qm {

/// Points that a patch is drawn to, on a lattice of parameters: (us[i], vs[j]) at j * us.size() + i.
struct PatchTargets {
    std::array<std::vector<double>, 2> parameters;
    std::vector<Point> points;
    std::vector<double> weights; ///< factors of the squared distances
};

/// The lower half of the form's matrix, by control point.
/// \param plates  by quad, row by row
[[nodiscard]] Eigen::SparseMatrix<double> patchForm(const PatchSpace& space, const PatchTargets& targets,
                                                    const std::vector<ThinPlate>& plates);

/// Adds the form's right-hand side to the rows of the patch's unknowns.
void addPatchTargets(const PatchSpace& space, const PatchTargets& targets, Eigen::MatrixX3d& rightHandSide);

} // namespace qm
