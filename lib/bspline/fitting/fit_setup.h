/// \file What a fit is made of, whatever knots are chosen, and the knots that it begins with.
#pragma once

#include "bspline/fitting/energy/thin_plate.h"
#include "bspline/fitting/fit_options.h"
#include "bspline/fitting/fit_problem.h"
#include "bspline/fitting/knots/even_vertices.h"
#include "bspline/fitting/knots/knot_plan.h"
#include "bspline/fitting/lattice/fit_lattice.h"
#include "bspline/fitting/lattice/normal_limits.h"
#include "bspline/network/stretch_map.h"

#include <array>
#include <cstddef>
#include <vector>

namespace qm {

/// Does not change during a fit; all lists are by patch.
struct FitSetup {
    /// What is passed must outlive it.
    /// \param isSoft  by patch: whether it follows the reference more closely at the cost of fairness
    FitSetup(const FitProblem& problem, const SmoothFitOptions& fitOptions, const std::vector<bool>& isSoft,
             unsigned threads);

    const Layout& layout;
    const SmoothFitOptions& options;
    unsigned jobs;
    StretchMap map;
    std::vector<EvenVertex> evenVertices;
    KnotPlan planWithoutKnots;
    std::vector<LatticeSource> sources;
    std::vector<NormalLimits> normalLimits;
    std::vector<std::vector<ThinPlate>> plates; ///< by quad

    /// Those of a patch's lattice.
    [[nodiscard]] std::array<std::vector<double>, 2>
    parametersOf(std::size_t patch, const std::array<std::vector<double>, 2>& knots) const;

    /// A lattice without knots, so that steps are equal, with the reference as its target.
    [[nodiscard]] FitLattice evenLattice(std::size_t patch) const;
    [[nodiscard]] std::vector<FitLattice> evenLattices() const;

    /// The fewest knots that are likely to suffice: those between which single cubics are near enough.
    /// \param lattices  of equal steps
    /// \param share     by patch: how much nearer than usual they are to be
    [[nodiscard]] KnotPlan firstKnots(const std::vector<FitLattice>& lattices,
                                      const std::vector<double>& share) const;
};

} // namespace qm
