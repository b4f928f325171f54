/// \file The matrices of least squares with B-splines.
#pragma once

#include "bspline/basis.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <span>
#include <vector>

namespace qm {

using SparseMatrix = Eigen::SparseMatrix<double>;

/// Parameters at which a target is given: `steps` for every edge, both ends included.
[[nodiscard]] std::vector<double> sampleParameters(int edges, int steps);

/// Samples for every edge in all fits. Four determine every polyline's spline, whatever the knots.
constexpr int fitSteps = 4;

/// One row for every parameter, with the values there of all basis functions over clamped knots.
[[nodiscard]] SparseMatrix designMatrix(std::span<const double> knots, std::span<const double> parameters);

} // namespace qm
