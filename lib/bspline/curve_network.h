/// \file Curves through the layout's border vertices that neighbouring patches share, with the derivatives
/// across them.
#pragma once

#include "bspline/chains.h"
#include "bspline/line_derivatives.h"
#include "bspline/spline_curve.h"

#include <array>
#include <vector>

namespace qm {

/// What a patch needs of one of its sides, in the side's direction: the border itself, and the derivative
/// that leads from it into the patch.
struct SideCurves {
    SplineCurve position;
    SplineCurve inwards;
};

/// On every chain one twice continuously differentiable spline through its vertices, and on either side one
/// for the derivative across. Where a chain ends on another, its tangent there is the other's derivative
/// across, and its twist is that derivative's slope: so patches agree at their corners, and two patches
/// beside a smooth chain have one tangent plane along it.
class CurveNetwork {
public:
    CurveNetwork(const QuadMesh& mesh, const Chains& chains, const LineDerivatives& lines);

    [[nodiscard]] SideCurves side(std::size_t patch, int side) const;

private:
    /// Of one chain, walked one way.
    struct Across {
        std::vector<Point> values;
        std::vector<Point> slopes; ///< first and last are the twists at the chain's ends
        bool present = false;
    };

    void fitPositions();
    void prepareAcross();
    void settleTwists();
    double updateTwists();
    void solve(Across& across);
    [[nodiscard]] Point tangentAt(HalfedgeId halfedge) const;
    [[nodiscard]] Point twistAtStart(const ChainPlace& first) const;
    [[nodiscard]] Point twistAtEnd(const ChainPlace& last) const;
    [[nodiscard]] HalfedgeId acrossAt(const ChainPlace& place) const;
    [[nodiscard]] HalfedgeId acrossAtEnd(const ChainPlace& last) const;

    const QuadMesh& mesh_;
    const Chains& chains_;
    const LineDerivatives& lines_;
    std::vector<SplineCurve> positions_;              ///< by chain, walked forwards
    std::vector<std::vector<Point>> slopes_;          ///< by chain, at every vertex
    std::vector<std::array<Across, 2>> across_;       ///< by chain and way
    std::vector<std::array<SplineCurve, 2>> inwards_; ///< by chain and way, in the way's direction
};

} // namespace qm
