/// \file What a patch is to minimise: weighted squared distances from points, and bending.
#pragma once

#include "bspline/fitting/thin_plate.h"
#include "bspline/network/border_strip.h"
#include "bspline/splines/basis.h"
#include "mesh/quad_mesh.h"

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <array>
#include <vector>

namespace qm {

/// Points that a patch should come near to, at a lattice of parameters: (us[i], vs[j]) at j * us.size() + i.
struct PatchTargets {
    std::array<std::vector<double>, 2> parameters;
    std::vector<Point> points;
    std::vector<double> weights; ///< of the squared distances
};

/// The matrix of the quadratic form, one half of it: adds (row, column, value) with row >= column.
/// \param plates  by quad, row by row
void addPatchForm(const PatchSpace& space, const PatchTargets& targets, const std::vector<ThinPlate>& plates,
                  std::vector<Eigen::Triplet<double>>& entries);

/// The right-hand side that belongs to it: adds to the rows of the patch's unknowns.
void addPatchTargets(const PatchSpace& space, const PatchTargets& targets, Eigen::MatrixX3d& rightHandSide);

} // namespace qm
