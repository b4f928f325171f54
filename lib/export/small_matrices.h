/// \file What fits ask of small matrices. Their sizes are found out at run time: for each fixed one the
/// compiler would take many seconds.
#pragma once

#include <Eigen/Core>

namespace qm {

/// The unit eigenvector of the smallest eigenvalue.
/// \param matrix  symmetric
[[nodiscard]] Eigen::VectorXd minEigenvector(const Eigen::MatrixXd& matrix);

/// Of all vectors that come nearest to solving a system of linear equations, the shortest.
/// \param matrix  square
/// \param threshold  smaller pivots, as shares of the largest, count as zero; 0: what rounding leaves
[[nodiscard]] Eigen::VectorXd minNormSolution(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right,
                                              double threshold = 0);

} // namespace qm
