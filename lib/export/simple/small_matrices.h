/// \file Linear algebra of small matrices. Their sizes are not fixed at compile time: each fixed size would
/// take the compiler many seconds.
#pragma once

#include <Eigen/Core>

namespace qm {

/// The unit eigenvector for the smallest eigenvalue.
/// \param matrix  symmetric
[[nodiscard]] Eigen::VectorXd minEigenvector(const Eigen::MatrixXd& matrix);

/// The shortest of all vectors with the smallest residual of a system of linear equations.
/// \param matrix     square
/// \param threshold  smaller pivots, relative to the largest, count as zero; 0: rounding errors only
[[nodiscard]] Eigen::VectorXd minNormSolution(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right,
                                              double threshold = 0);

} // namespace qm
