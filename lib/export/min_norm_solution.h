/// \file Small systems of linear equations that may leave something open.
#pragma once

#include <Eigen/Core>

namespace qm {

/// Of all solutions nearest to a system's right-hand side the smallest. For matrices of any small size; of
/// fixed sizes, each would take the compiler many seconds.
/// \param matrix  square
/// \param threshold  pivots count for nothing that are smaller than this, times the largest; 0: that of rounding
[[nodiscard]] Eigen::VectorXd minNormSolution(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right,
                                              double threshold = 0);

} // namespace qm
