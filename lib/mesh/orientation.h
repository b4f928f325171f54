/// \file Orienting the quads of a soup consistently.
#pragma once

#include "mesh/soup_edges.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace qm {

struct Orientation {
    /// For every quad whether it must be reversed so that neighbours agree: the fewer of each component, and
    /// if it is a tie, not the component's first.
    std::vector<bool> reversed;
    /// The first quad that cannot agree with all its neighbours: the surface has one side only.
    std::optional<std::size_t> contradiction;
};

/// Quads are neighbours where just two meet at an edge.
/// \param twins  see `twinSides`
[[nodiscard]] Orientation findOrientation(const Soup& soup, const std::vector<Side>& twins);

} // namespace qm
