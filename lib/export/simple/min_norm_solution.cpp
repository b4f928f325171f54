#include "export/simple/small_matrices.h"

#include <Eigen/QR>

namespace qm {

Eigen::VectorXd minNormSolution(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right,
                                double threshold) {
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
    if (threshold > 0) solver.setThreshold(threshold);
    solver.compute(matrix);
    return solver.solve(right);
}

} // namespace qm
