#include "bspline/reference/bending/quad_bending.h"

#include "base/at.h"
#include "bspline/reference/lattice/hermite.h"
#include "bspline/splines/eigen_point.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

namespace qm {
namespace {

/// What a tilt changes at a corner.
struct CornerChange {
    std::array<double, 2> slopes; ///< of the lines of parameters, by direction
    double twist = 0;             ///< the mixed derivative
};

/// How high a tilt lifts the surface along the corner's normal: products of cubics in u and v.
class Lift {
public:
    Lift(const Hermite& u, const Hermite& v, std::size_t corner, const CornerChange& change)
        : u_(u), v_(v), ends_(quadCorners[corner]), change_(change) {}

    /// \param du, dv  how often it is derived
    [[nodiscard]] double operator()(std::size_t du, std::size_t dv) const {
        const double slopeU = u_.slope[ends_[0]][du];
        const double slopeV = v_.slope[ends_[1]][dv];
        return change_.slopes[0] * slopeU * v_.value[ends_[1]][dv] +
               change_.slopes[1] * u_.value[ends_[0]][du] * slopeV + change_.twist * slopeU * slopeV;
    }

private:
    const Hermite& u_;
    const Hermite& v_;
    const std::array<std::size_t, 2>& ends_;
    CornerChange change_;
};

CornerChange changeOf(const QuadSurface& surface, std::size_t corner, const TangentFrame& frame,
                      const Eigen::Vector3d& tilt) {
    const Eigen::Vector3d slope = tilt[0] * frame.axes[0] + tilt[1] * frame.axes[1];
    const Eigen::Vector3d& u = surface.derivative(corner, 0);
    const Eigen::Vector3d& v = surface.derivative(corner, 1);
    const auto& [first, second] = frame.dual;
    const auto inwards = [&](std::size_t direction) {
        return quadCorners[corner][direction] == 0 ? 1.0 : -1.0;
    };
    return {{slope.dot(u), slope.dot(v)},
            tilt[2] * (first.dot(u) * second.dot(v) + second.dot(u) * first.dot(v)) +
                frame.twistOfSlopes * (inwards(1) * slope.dot(u) + inwards(0) * slope.dot(v))};
}

/// Second derivatives in space, from those by u and v: those of the surface itself are its second fundamental
/// form, those of a lift its Hessian, both in an orthonormal frame.
class Geometry {
public:
    explicit Geometry(const QuadSurface::SecondOrder& at) : at_(at) {
        metric_ << at.u.squaredNorm(), at.u.dot(at.v), at.u.dot(at.v), at.v.squaredNorm();
        const double length = std::sqrt(metric_(0, 0));
        const double height = std::sqrt(metric_.determinant()) / length;
        frame_ << 1 / length, 0, -metric_(0, 1) / (metric_(0, 0) * height), 1 / height;
    }

    /// False where the derivatives are parallel, or nearly so, or one is zero.
    [[nodiscard]] bool isRegular() const {
        constexpr double minSquaredSine = 1e-6;
        return metric_.determinant() > minSquaredSine * metric_(0, 0) * metric_(1, 1);
    }
    [[nodiscard]] double area() const { return std::sqrt(metric_.determinant()); }
    [[nodiscard]] Eigen::Vector3d normal() const { return at_.u.cross(at_.v).normalized(); }

    /// The entries of a symmetric form, whose squares sum to that of both its eigenvalues.
    [[nodiscard]] Eigen::Vector3d inFrame(double uu, double uv, double vv) const {
        Eigen::Matrix2d form;
        form << uu, uv, uv, vv;
        const Eigen::Matrix2d whole = frame_ * form * frame_.transpose();
        return {whole(0, 0), std::numbers::sqrt2 * whole(0, 1), whole(1, 1)};
    }
    [[nodiscard]] Eigen::Vector3d ofSurface() const {
        const Eigen::Vector3d n = normal();
        return inFrame(n.dot(at_.uu), n.dot(at_.uv), n.dot(at_.vv));
    }
    /// \param share  of the lift that is along the normal here
    [[nodiscard]] Eigen::Vector3d ofLift(const Lift& lift, double share) const {
        const Eigen::Vector2d slopes =
            frame_.transpose() * (frame_ * Eigen::Vector2d(lift(1, 0), lift(0, 1)));
        const Eigen::Vector3d gradient = slopes[0] * at_.u + slopes[1] * at_.v;
        return share * inFrame(lift(2, 0) - gradient.dot(at_.uu), lift(1, 1) - gradient.dot(at_.uv),
                               lift(0, 2) - gradient.dot(at_.vv));
    }

private:
    const QuadSurface::SecondOrder& at_;
    Eigen::Matrix2d metric_;
    Eigen::Matrix2d frame_; ///< its rows: an orthonormal frame's vectors in terms of u and v
};

/// A point of Gauss's rule on the unit interval.
struct GaussPoint {
    double weight;
    Hermite hermite;
    LagrangeWeights lagrange;
};

/// Three points: with two, some twists would not bend anything.
using GaussRule = std::array<GaussPoint, 3>;

GaussRule gaussRule(int steps) {
    constexpr double outer = 0.3872983346207417; // half of the root of 3/5
    const auto point = [&](double t, double weight) {
        return GaussPoint{weight, Hermite(t), lagrange(steps, t)};
    };
    return {point(0.5 - outer, 5.0 / 18), point(0.5, 8.0 / 18), point(0.5 + outer, 5.0 / 18)};
}

/// What one unit of every entry of a tilt changes, by corner.
std::array<std::array<CornerChange, 3>, 4> unitChanges(const QuadSurface& surface,
                                                       const CornerFrames& frames) {
    std::array<std::array<CornerChange, 3>, 4> changes{};
    for (std::size_t corner = 0; corner < frames.size(); ++corner)
        for (std::size_t k = 0; frames[corner] != nullptr && k < 3; ++k)
            changes[corner][k] =
                changeOf(surface, corner, *frames[corner], Eigen::Vector3d::Unit(eigenIndex(k)));
    return changes;
}

} // namespace

double twistOfSlopes(int valence) {
    // Of two quads, both edges lie in one line, and no quad is across.
    if (valence < 3 || valence == 4) return 0;
    // Let a be the lift along an edge, with the slope s at the vertex, and b, c the lifts across it into the
    // quads on both sides. Tangent quads have b + c = lambda a'. As a'' = -4 s in the cubic, both twists have
    // to sum to -4 lambda s; and the slopes along the next edges on both sides to lambda s.
    const double lambda = 2 * std::cos(2 * std::numbers::pi / valence);
    return -4 * lambda / (2 + lambda);
}

QuadSurface::QuadSurface(int steps, std::vector<Eigen::Vector3d> points)
    : steps_(steps), points_(std::move(points)) {
    const std::array<std::size_t, 2> stride{1, at(steps_) + 1};
    for (std::size_t corner = 0; corner < quadCorners.size(); ++corner)
        for (std::size_t d = 0; d < 2; ++d) {
            const std::size_t first = quadCorners[corner][1 - d] * at(steps_) * stride[1 - d];
            derivatives_[corner][d] =
                derivativeAtEnd(steps_, quadCorners[corner][d], [&](int k) -> const Eigen::Vector3d& {
                    return points_[first + at(k) * stride[d]];
                });
        }
}

QuadSurface::SecondOrder QuadSurface::secondOrder(const LagrangeWeights& columns,
                                                  const LagrangeWeights& rows) const {
    const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
    SecondOrder sum{zero, zero, zero, zero, zero};
    const Eigen::Vector3d* point = points_.data();
    for (std::size_t j = 0; j <= at(steps_); ++j)
        for (std::size_t i = 0; i <= at(steps_); ++i, ++point) {
            sum.u += columns[i][1] * rows[j][0] * *point;
            sum.v += columns[i][0] * rows[j][1] * *point;
            sum.uu += columns[i][2] * rows[j][0] * *point;
            sum.uv += columns[i][1] * rows[j][1] * *point;
            sum.vv += columns[i][0] * rows[j][2] * *point;
        }
    return sum;
}

Eigen::Vector3d QuadSurface::normal(std::size_t corner) const {
    return derivative(corner, 0).cross(derivative(corner, 1)).normalized();
}

std::vector<Eigen::Vector3d> QuadSurface::displacements(const CornerFrames& frames,
                                                        const CornerTilts& tilts) const {
    std::vector<Eigen::Vector3d> result(points_.size(), Eigen::Vector3d::Zero());
    const std::vector<Hermite> hermite = hermiteByStep(steps_);
    for (std::size_t corner = 0; corner < frames.size(); ++corner) {
        if (frames[corner] == nullptr) continue;
        const CornerChange change =
            changeOf(*this, corner, *frames[corner], tilts.segment<3>(eigenIndex(3 * corner)));
        for (std::size_t k = 0; k < result.size(); ++k)
            result[k] +=
                Lift(hermite[k % hermite.size()], hermite[k / hermite.size()], corner, change)(0, 0) *
                frames[corner]->normal;
    }
    return result;
}

QuadBending quadBending(const QuadSurface& surface, const CornerFrames& frames) {
    static const auto rules = forAllSteps(gaussRule);
    const GaussRule& points = rules[at(surface.steps() - 1)];
    const auto changes = unitChanges(surface, frames);
    QuadBending bending{Eigen::Matrix<double, 12, 12>::Zero(), CornerTilts::Zero()};
    for (const GaussPoint& u : points)
        for (const GaussPoint& v : points) {
            const QuadSurface::SecondOrder at = surface.secondOrder(u.lagrange, v.lagrange);
            const Geometry geometry(at);
            if (!geometry.isRegular()) continue;
            Eigen::Matrix<double, 3, 12> change = Eigen::Matrix<double, 3, 12>::Zero();
            for (std::size_t corner = 0; corner < frames.size(); ++corner) {
                if (frames[corner] == nullptr) continue;
                const double share = frames[corner]->normal.dot(geometry.normal());
                for (std::size_t k = 0; k < 3; ++k)
                    change.col(eigenIndex(3 * corner + k)) =
                        geometry.ofLift(Lift(u.hermite, v.hermite, corner, changes[corner][k]), share);
            }
            const double weight = u.weight * v.weight * geometry.area();
            bending.matrix += weight * change.transpose() * change;
            bending.right -= weight * change.transpose() * geometry.ofSurface();
        }
    return bending;
}

} // namespace qm
