#include "export/simple/small_matrices.h"

#include <Eigen/Eigenvalues>

namespace qm {

Eigen::VectorXd minEigenvector(const Eigen::MatrixXd& matrix) {
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix).eigenvectors().col(0);
}

} // namespace qm
