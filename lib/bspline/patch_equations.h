/// \file Least squares for a patch's inner control points, whose coordinates may depend on one another.
#pragma once

#include "bspline/basis.h"
#include "bspline/surfaces.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace qm {

/// Weights of four successive basis functions in one direction: of their values, or of a derivative.
struct BasisWeights {
    std::size_t first = 0;
    std::array<double, 4> weight{};
};

[[nodiscard]] BasisWeights valueWeights(const BasisValues& basis);
[[nodiscard]] BasisWeights derivativeWeights(const BasisValues& basis);

/// Normal equations. Every term asks that a combination of control points be near a target; a metric, a
/// symmetric positive semi-definite matrix, says how much it counts in which direction. The outermost control
/// points are given.
class PatchEquations {
public:
    /// \param patch  its knots, and its border's control points
    explicit PatchEquations(const Patch& patch);

    void add(const BasisWeights& u, const BasisWeights& v, const Eigen::Matrix3d& metric,
             const Point& target);

    /// The patch with the best inner control points. The terms must determine them.
    [[nodiscard]] Patch solve() const;

private:
    static constexpr std::size_t span = 4;    ///< successive basis functions that overlap
    static constexpr std::size_t reach = 7;   ///< of a control point along a direction, both ways
    static constexpr std::size_t blocks = 25; ///< that couple a control point with itself and later ones

    [[nodiscard]] std::size_t unknown(std::size_t i, std::size_t j) const;
    [[nodiscard]] Eigen::VectorXd solveDense() const;
    [[nodiscard]] Eigen::VectorXd solveSparse() const;
    [[nodiscard]] bool isSeparate() const;
    [[nodiscard]] Eigen::VectorXd solveSeparately() const;
    template <class Visitor> void visitLower(const Visitor& visit) const;

    const Patch& patch_;
    std::array<std::size_t, 2> inner_;    ///< control points that are sought, along u and v
    std::vector<Eigen::Matrix3d> matrix_; ///< `blocks` for every unknown
    Eigen::VectorXd right_;
};

} // namespace qm
