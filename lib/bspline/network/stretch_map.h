/// \file Which stretches lie on which side of which patch, and what is across them.
#pragma once

#include "base/at.h"
#include "bspline/network/smooth_network.h"
#include "layout/layout.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace qm {

/// A side of a patch as one of the two that a stretch joins.
struct StretchEnd {
    std::size_t stretch = 0;
    std::size_t which = 0;
};

/// The place of a neighbour that lies across a border.
struct PlaceAcross {
    std::size_t patch = 0;
    std::size_t direction = 0; ///< 0 if u runs along the border, 1 if v does
    double parameter = 0;      ///< along it
    bool isSmooth = false;     ///< the border is no crease there
};

class StretchMap {
public:
    /// What is passed must outlive the map.
    StretchMap(const QuadMesh& mesh, const Layout& layout, const SmoothNetwork& network);

    /// All stretches on a side of a patch.
    [[nodiscard]] const std::vector<StretchEnd>& on(std::size_t patch, int side) const {
        return sides_[patch][at(side)];
    }

    /// What lies across a side at a parameter of the patch along it; nothing on the mesh boundary.
    [[nodiscard]] std::optional<PlaceAcross> across(std::size_t patch, int side, double parameter) const;

private:
    const QuadMesh& mesh_;
    const Layout& layout_;
    const SmoothNetwork& network_;
    std::vector<std::array<std::vector<StretchEnd>, 4>> sides_;
};

} // namespace qm
