/// \file The result of one round of fitting, and which of two results is better.
#pragma once

#include "bspline/fitting/knots/knot_plan.h"
#include "bspline/fitting/lattice/fit_lattice.h"
#include "bspline/fitting/lattice/given_up_cells.h"
#include "bspline/splines/surfaces.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace qm {

/// The values by which rounds are compared.
struct RoundScore {
    bool keeps = false; ///< whether the tolerance is kept, apart from cells that are given up
    double missed = 0;  ///< in all, cells that are given up included; the largest counts most
    std::size_t controlPoints = 0;

    bool operator==(const RoundScore&) const = default;
};

struct FitRound {
    RoundScore score;
    std::vector<Patch> patches; ///< empty before the first round
    std::optional<KnotPlan> plan;
    /// By patch; shared between rounds, because they are large.
    std::vector<std::shared_ptr<const LatticeProgress>> lattices;
    std::vector<GivenUpCells> givenUp; ///< by patch
    std::vector<double> distances;     ///< by patch, in tolerances, if they have been verified
};

/// What counts first when two rounds are compared.
enum class Criterion {
    tolerance, ///< whether a round keeps it, apart from cells that are given up
    errors     ///< those of cells that are given up as well
};

/// Compares two rounds: among those that keep the tolerance the one with fewer control points is better,
/// otherwise the one with smaller errors.
[[nodiscard]] bool isBetter(const RoundScore& one, const RoundScore& other, Criterion first);

} // namespace qm
