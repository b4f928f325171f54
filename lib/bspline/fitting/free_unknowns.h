/// \file A part of the unknowns of a layout's surfaces: those of some patches, while the others stay.
#pragma once

#include "bspline/network/border_strip.h"
#include "bspline/network/smooth_network.h"

#include <cstddef>
#include <vector>

namespace qm {

/// The patches that some have borders with, and theirs, so many times, and these themselves.
[[nodiscard]] std::vector<bool> withNeighbours(const SmoothNetwork& network, std::vector<bool> patches,
                                               int rings);

/// Numbers the unknowns of free patches from 0 on.
class FreeUnknowns {
public:
    /// \param isFree  by patch
    FreeUnknowns(const std::vector<PatchSpace>& spaces, const std::vector<bool>& isFree);

    [[nodiscard]] std::size_t count() const { return count_; }
    [[nodiscard]] bool isFree(std::size_t unknown) const { return numbers_[unknown] != none; }
    /// \param unknown  of all; a free one
    [[nodiscard]] std::size_t number(std::size_t unknown) const { return numbers_[unknown]; }

    /// What a form says of free unknowns, by their numbers; perhaps nothing.
    [[nodiscard]] LinearForm among(const LinearForm& form) const;

private:
    static constexpr std::size_t none = static_cast<std::size_t>(-1);
    std::vector<std::size_t> numbers_; ///< of all unknowns
    std::size_t count_ = 0;
};

} // namespace qm
