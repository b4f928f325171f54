#include "bspline/reference/planes/principal_axes.h"

#include <Eigen/Eigenvalues>

namespace qm {

PrincipalAxes principalAxes(const std::vector<Eigen::Vector3d>& points) {
    const auto count = static_cast<double>(points.size());
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& at : points)
        middle += at;
    middle /= count;
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const Eigen::Vector3d& at : points)
        spread += (at - middle) * (at - middle).transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);
    return {middle, (solver.eigenvalues().cwiseMax(0.0) / count).cwiseSqrt(), solver.eigenvectors()};
}

} // namespace qm
