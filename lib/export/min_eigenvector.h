/// \file The direction in which a quadratic form is smallest.
#pragma once

#include <Eigen/Core>

namespace qm {

/// Of the smallest eigenvalue, unit. For matrices of any small size: of fixed sizes, each would take the
/// compiler many seconds.
/// \param matrix  symmetric
[[nodiscard]] Eigen::VectorXd minEigenvector(const Eigen::MatrixXd& matrix);

} // namespace qm
