/// \file The unknowns of those patches that are solved for, while all other patches stay as they are.
#pragma once

#include "bspline/network/border_strip.h"

#include <cstddef>
#include <vector>

namespace qm {

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
