/// \file Knots to begin with: single cubics over as many quads as come near the reference.
#pragma once

#include "bspline/fitting/fit_lattice.h"
#include "bspline/fitting/knot_plan.h"
#include "bspline/fitting/normal_limits.h"
#include "bspline/network/stretch_map.h"

#include <vector>

namespace qm {

/// Into a plan without knots, for lattices of equal steps: inserts knots at grid lines, patch by patch, the
/// farthest apart for which a cubic along every line of the lattice is within `tolerance` of it and its
/// normals within their limits; where a neighbour has a knot that is not much nearer, that one is taken, for
/// only knots of both sides serve their common border.
void insertInitialKnots(const Layout& layout, const std::vector<FitLattice>& lattices,
                        const std::vector<NormalLimits>& limits, const StretchMap& map, double tolerance,
                        KnotPlan& plan);

/// The knots that a patch's neighbours have across the sides along u (0) or v (1), as its own parameters,
/// ascending.
[[nodiscard]] std::vector<double> knotsBeside(const Layout& layout, const StretchMap& map,
                                              const KnotPlan& plan, std::size_t patch, std::size_t direction);

} // namespace qm
