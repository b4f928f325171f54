/// \file Least squares for a patch's inner control points, whose coordinates may depend on one another.
#pragma once

#include "bspline/basis.h"
#include "bspline/surfaces.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <span>
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

    /// The same for the values at all points of a lattice, row by row, at a fraction of the cost: what the
    /// points of a row have in common is gathered first. \param us  the basis at the columns' parameters
    /// \param vs  at the rows' \param weights  of the metrics
    void addLattice(const std::vector<BasisValues>& us, const std::vector<BasisValues>& vs,
                    std::span<const double> weights, std::span<const Eigen::Matrix3d> metrics,
                    std::span<const Point> targets);

    /// The patch with the best inner control points. The terms must determine them.
    [[nodiscard]] Patch solve() const;

private:
    static constexpr std::size_t span = 4;    ///< successive basis functions that overlap
    static constexpr std::size_t reach = 7;   ///< of a control point along a direction, both ways
    static constexpr std::size_t blocks = 25; ///< that couple a control point with itself and later ones

    /// What the points of a row ask of combinations of columns of control points.
    struct Row {
        std::vector<Eigen::Matrix3d> pairs; ///< `span` for every column, with itself and the next ones
        std::vector<Eigen::Vector3d> right;
    };
    void addRow(const BasisWeights& v, const Row& row);
    [[nodiscard]] bool isKnown(std::size_t i, std::size_t j) const {
        return i == 0 || j == 0 || i > inner_[0] || j > inner_[1];
    }
    [[nodiscard]] std::size_t unknown(std::size_t i, std::size_t j) const;
    [[nodiscard]] Eigen::VectorXd solveTogether() const;
    [[nodiscard]] bool isSeparate() const;
    [[nodiscard]] Eigen::VectorXd solveSeparately() const;
    template <class Visitor> void visitLower(const Visitor& visit) const;

    const Patch& patch_;
    std::array<std::size_t, 2> inner_;    ///< control points that are sought, along u and v
    std::vector<Eigen::Matrix3d> matrix_; ///< `blocks` for every unknown
    Eigen::VectorXd right_;
};

} // namespace qm
