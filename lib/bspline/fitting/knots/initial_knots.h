/// \file The knots of the first round: as far apart as single cubics follow the reference.
#pragma once

#include "bspline/fitting/knots/knot_plan.h"
#include "bspline/fitting/lattice/fit_lattice.h"
#include "bspline/fitting/lattice/normal_limits.h"
#include "bspline/network/stretch_map.h"

#include <vector>

namespace qm {

/// A knot that others have is taken in place of one farther away, if its interval has at least this share of
/// the length.
constexpr double notMuchNearer = 0.5;

/// Inserts knots at grid lines into a plan that has none, patch by patch, as far apart as possible: between
/// two knots a cubic along every line of the lattice is within the patch's tolerance of it, with normals
/// within their limits. If a neighbour has a knot that is not much nearer, that one is taken, because only
/// knots that both sides have serve the border between them. The lattices must have equal steps.
/// \param tolerances  by patch
void insertInitialKnots(const std::vector<FitLattice>& lattices, const std::vector<NormalLimits>& limits,
                        const StretchMap& map, const std::vector<double>& tolerances, KnotPlan& plan);

/// The knots of a patch's neighbours along the sides in direction u (0) or v (1), as parameters of the patch,
/// ascending.
[[nodiscard]] std::vector<double> knotsBeside(const StretchMap& map, const KnotPlan& plan, std::size_t patch,
                                              std::size_t direction);

} // namespace qm
