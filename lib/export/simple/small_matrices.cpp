#include "export/simple/small_matrices.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

namespace qm {

Eigen::VectorXd minEigenvector(const Eigen::MatrixXd& matrix) {
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix).eigenvectors().col(0);
}

Eigen::VectorXd minNormSolution(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right,
                                double threshold) {
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
    if (threshold > 0) solver.setThreshold(threshold);
    solver.compute(matrix);
    return solver.solve(right);
}

} // namespace qm
