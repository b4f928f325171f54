/// \file What a round of fitting has come to, and which of two is better.
#pragma once

#include "bspline/fitting/fit_lattice.h"
#include "bspline/fitting/knot_plan.h"
#include "bspline/fitting/lattice_errors.h"
#include "bspline/splines/surfaces.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace qm {

/// By what rounds are compared.
struct RoundScore {
    bool keeps = false; ///< the tolerance, but where it is given up
    double missed = 0;  ///< of all patches, whatever is given up: the largest counts most
    std::size_t controlPoints = 0;

    bool operator==(const RoundScore&) const = default;
};

struct FitRound {
    RoundScore score;
    std::vector<Patch> patches; ///< none: there was no round yet
    std::optional<KnotPlan> plan;
    std::vector<std::shared_ptr<const LatticeProgress>>
        lattices;                  ///< by patch; rounds share them: they are large
    std::vector<double> distances; ///< by patch, in tolerances, where they have been verified
};

/// By how much a patch is farther away than allowed, in tolerances; folds alone count little.
[[nodiscard]] double missedBy(const PatchErrors& errors);

/// \param missed  by patch
[[nodiscard]] RoundScore scoreOf(const std::vector<double>& missed, bool keeps,
                                 const std::vector<Patch>& patches);

/// Within the tolerance the fewest control points are best, else the smallest errors.
/// \param keepsFirst  whether to keep the tolerance but for cells that are given up is better than not to,
/// however much is missed there
[[nodiscard]] bool isBetter(const RoundScore& one, const RoundScore& other, bool keepsFirst);

} // namespace qm
