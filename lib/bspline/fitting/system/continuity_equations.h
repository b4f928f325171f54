/// \file The continuity equations of all surfaces of a layout, and those of their unknowns that are solved
/// for.
#pragma once

#include "bspline/fitting/knots/knot_plan.h"
#include "bspline/solver/linear_form.h"
#include "bspline/splines/patch_space.h"

#include <cstddef>
#include <vector>

namespace qm {

/// C0 along all stretches and G1 along all smooth runs: each form must be 0 in every coordinate.
/// \param plan    of the network, with the runs' ratios
/// \param isFree  by patch; equations between patches that are not free are left out
[[nodiscard]] std::vector<LinearForm> continuityEquations(const KnotPlan& plan,
                                                          const std::vector<PatchSpace>& spaces,
                                                          const std::vector<bool>& isFree);

/// The number of control points of all patches.
[[nodiscard]] std::size_t unknownsOf(const std::vector<PatchSpace>& spaces);

/// Numbers the unknowns of the free patches consecutively from 0.
class FreeUnknowns {
public:
    /// \param isFree  by patch
    FreeUnknowns(const std::vector<PatchSpace>& spaces, const std::vector<bool>& isFree);

    [[nodiscard]] std::size_t count() const { return count_; }
    [[nodiscard]] bool isFree(std::size_t unknown) const { return numbers_[unknown] != none; }
    /// \param unknown  number among the unknowns of all patches; its patch must be free
    [[nodiscard]] std::size_t number(std::size_t unknown) const { return numbers_[unknown]; }

    /// The terms of a form that contain free unknowns, renumbered; may be empty.
    [[nodiscard]] LinearForm among(const LinearForm& form) const;

private:
    static constexpr std::size_t none = static_cast<std::size_t>(-1);
    std::vector<std::size_t> numbers_; ///< by unknown of all patches
    std::size_t count_ = 0;
};

} // namespace qm
