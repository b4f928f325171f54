/// \file What the knots of border curves cost: a patch needs those of all its sides.
#pragma once

#include "bspline/chains.h"
#include "bspline/spline_curve.h"
#include "layout/layout.h"

#include <cstddef>
#include <vector>

namespace qm {

/// A place for a knot of a chain's curve, and how many control points it takes in the patches beside it: none
/// in those whose opposite side has that knot too.
struct KnotPlace {
    double parameter = 0;
    int cost = 0;
};

/// Which sides lie opposite which parts of which chains.
class KnotSharing {
public:
    KnotSharing(const Chains& chains, const Layout& layout);

    /// A curve's own inner knots and those on the opposite sides of its patches, each once, the most
    /// expensive ones first. \param curves  by chain, walked forwards
    [[nodiscard]] std::vector<KnotPlace> places(std::size_t chain,
                                                const std::vector<SplineCurve>& curves) const;

private:
    /// A part of a chain that faces a part of a chain, its own or another, across a patch.
    struct Facing {
        double begin = 0; ///< of the part, on the chain
        double end = 0;
        std::size_t opposite = 0;
        double first = 0; ///< parameter on the opposite chain that belongs to `begin`
        int sign = 1;     ///< in which direction that one runs
        std::size_t patch = 0;
        int cost = 0;
    };

    std::vector<std::vector<Facing>> facings_; ///< by chain
};

} // namespace qm
