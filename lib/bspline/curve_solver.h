/// \file The best spline curve over given knots.
#pragma once

#include "bspline/basis.h"
#include "bspline/curve_fit.h"
#include "bspline/knot_refinement.h"

#include <Eigen/Core>

#include <vector>

namespace qm {

/// Weight of the tangents' planes while knots are looked for: less than what makes a curve need more of them.
constexpr double searchWeight = 1;

/// Least squares over samples of the polyline, with ends and fixed points met exactly. Where an error is
/// large its weight grows, and the same is solved again.
class CurveSolver {
public:
    /// \param input  must outlive the solver \param nearPlanes  a curve does not fit if one of its tangents
    /// is far from its plane
    CurveSolver(const CurveFitInput& input, double tolerance, double exact, bool nearPlanes);

    /// \param planes  how much the slopes at the ends and the tangents' planes count \param degree  less than
    /// three only over knots without inner ones
    [[nodiscard]] SplineCurve attempt(const std::vector<double>& knots, double planes, int degree = 3) const;

    /// Marks where the tolerance is exceeded, a fixed point missed or a tangent far off. False if nowhere.
    bool mark(const SplineCurve& curve, KnotRefinement& refinement) const;

    [[nodiscard]] bool fits(const SplineCurve& curve) const;

    /// Integers at which the polyline turns so much that no smooth curve should follow it.
    [[nodiscard]] std::vector<bool> sharpPoints() const;

private:
    [[nodiscard]] const Point& point(int k) const { return input_.points[static_cast<std::size_t>(k)]; }
    [[nodiscard]] Point onPolyline(double t) const;
    [[nodiscard]] Closeness closenessAt(double t) const;
    [[nodiscard]] Eigen::Matrix3d metric(std::size_t sample) const;
    [[nodiscard]] SplineCurve solve(const std::vector<double>& knots, const std::vector<BasisValues>& table,
                                    const std::vector<double>& weights, double planes, int degree) const;
    [[nodiscard]] double counted(std::size_t sample, const Point& error) const;

    const CurveFitInput& input_;
    double exact_;
    bool nearPlanes_;
    std::size_t edges_;
    std::vector<double> parameters_;
    std::vector<Point> targets_;           ///< by sample
    std::vector<Closeness> closeness_;     ///< with the tolerance itself for its share
    std::vector<Eigen::Matrix3d> metrics_; ///< how much an error counts, more where less is allowed
};

} // namespace qm
