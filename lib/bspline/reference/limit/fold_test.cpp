#include "bspline/reference/limit/fold_test.h"

#include "base/at.h"
#include "bspline/splines/eigen_point.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>

namespace qm {
namespace {

/// Smallest cosine of the angle between a square and the quad's part below it: 60 degrees.
constexpr double minCosine = 0.5;

} // namespace

FoldTest::FoldTest(const MeshLattice& lattice, const FoldLimits& limits)
    : lattice_(lattice), limits_(limits) {
    const int squares = lattice_.squares();
    for (int k = 0; k <= squares; ++k)
        weights_.push_back(lagrange(squares, static_cast<double>(k) / squares));
}

BilinearQuad FoldTest::quad(FaceId face) const {
    const int end = lattice_.squares();
    const auto corner = [&](int i, int j) { return lattice_.point(face, i, j); };
    return BilinearQuad({corner(0, 0), corner(end, 0), corner(end, end), corner(0, end)});
}

bool FoldTest::foldsOver(FaceId face) const {
    const BilinearQuad below = quad(face);
    return foldsAtPoints(face, below) || foldsInSquares(face, below);
}

bool FoldTest::foldsInSquares(FaceId face, const BilinearQuad& quad) const {
    const int squares = lattice_.squares();
    const double side = 1.0 / squares;
    const auto point = [&](int i, int j) { return lattice_.point(face, i, j); };
    for (int j = 0; j < squares; ++j)
        for (int i = 0; i < squares; ++i) {
            const Point square =
                (point(i + 1, j + 1) - point(i, j)) % (point(i, j + 1) - point(i + 1, j)) / 2;
            const SurfacePoint below = quad.evaluate((i + 0.5) * side, (j + 0.5) * side);
            const Point part = (below.du % below.dv) * side * side;
            const double upright = square | part;
            if (!(upright >= minCosine * square.norm() * part.norm() &&
                  upright >= limits_.minArea * part.sqrnorm()))
                return true;
        }
    return false;
}

bool FoldTest::foldsAtPoints(FaceId face, const BilinearQuad& quad) const {
    const std::vector<Eigen::Vector3d> points = lattice_.points(face);
    const std::size_t width = weights_.size();
    const double side = 1.0 / lattice_.squares();
    for (std::size_t j = 0; j < width; ++j)
        for (std::size_t i = 0; i < width; ++i) {
            Eigen::Vector3d du(0, 0, 0), dv(0, 0, 0);
            for (std::size_t k = 0; k < width; ++k) {
                du += weights_[i][k][1] * points[j * width + k];
                dv += weights_[j][k][1] * points[k * width + i];
            }
            const SurfacePoint below =
                quad.evaluate(static_cast<double>(i) * side, static_cast<double>(j) * side);
            const Point part = below.du % below.dv;
            const auto speed = [&](const Eigen::Vector3d& derivative, const Point& ofQuad) {
                return std::clamp(derivative.norm() / ofQuad.norm(), limits_.minSpeed, 1.0);
            };
            const double minShare = limits_.minAreaAtPoint * speed(du, below.du) * speed(dv, below.dv);
            if (!(du.cross(dv).dot(vector(part)) >= minShare * part.sqrnorm())) return true;
        }
    return false;
}

} // namespace qm
