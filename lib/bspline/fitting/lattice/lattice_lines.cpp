#include "bspline/fitting/lattice/lattice_lines.h"

#include "base/at.h"
#include "bspline/fitting/lattice/lattice_errors.h"
#include "bspline/splines/eigen_point.h"

#include <algorithm>

namespace qm {
namespace {

/// Weight of an offset along the reference: the fit may slide, but not far.
constexpr double ofSlides = 0.15;

/// Number of coefficients of a cubic.
constexpr Eigen::Index coefficients = 4;

/// Orthonormal polynomials up to degree 3, at equally spaced places.
Eigen::MatrixX4d orthonormalCubics(Eigen::Index places) {
    Eigen::MatrixX4d basis(places, coefficients);
    for (Eigen::Index i = 0; i < places; ++i) {
        const double x = 2.0 * static_cast<double>(i) / static_cast<double>(places - 1) - 1;
        basis.row(i) << 1, x, x * x, x * x * x;
    }
    for (Eigen::Index k = 0; k < coefficients; ++k) {
        for (Eigen::Index before = 0; before < k; ++before)
            basis.col(k) -= basis.col(before).dot(basis.col(k)) * basis.col(before);
        basis.col(k).normalize();
    }
    return basis;
}

} // namespace

bool LatticeLines::fit(int begin, int end) {
    for (std::size_t line = 0; line < count(); ++line)
        if (!fits(line, begin, end)) return false;
    return true;
}

bool LatticeLines::fits(std::size_t line, int begin, int end) {
    const Eigen::Index places = Eigen::Index{end - begin} * steps() + 1;
    if (places <= coefficients) return true;
    auto [found, isNew] = bases_.try_emplace(places);
    if (isNew) found->second = orthonormalCubics(places);
    return isNear(line, at(begin) * at(steps()), found->second);
}

bool LatticeLines::isNear(std::size_t line, std::size_t begin, const Eigen::MatrixX4d& basis) const {
    Eigen::MatrixX3d points(basis.rows(), 3);
    for (Eigen::Index i = 0; i < basis.rows(); ++i)
        points.row(i) = vector(lattice_.reference[index(line, begin + static_cast<std::size_t>(i))]);
    points -= basis * (basis.transpose() * points).eval();
    for (Eigen::Index i = 0; i < basis.rows(); ++i) {
        const std::size_t k = begin + static_cast<std::size_t>(i);
        const std::size_t at = index(line, k);
        const double off = distance(lattice_, at, point(points.row(i)));
        if (std::max(off, ofSlides * points.row(i).norm()) > tolerance_) return false;
        if (i == 0) continue;
        const Point before = lattice_.reference[index(line, k - 1)];
        const double rise = distance(lattice_, at, point(points.row(i) - points.row(i - 1)));
        const double run = (lattice_.reference[at] - before).norm();
        if (rise > limits_.at(lattice_, direction_, line, k) * run) return false;
    }
    return true;
}

} // namespace qm
