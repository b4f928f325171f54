/// \file Turning the faces of a surface to the same side.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace qm {

/// Side n * f + k of face f, of n sides, leads from its corner k to the next. The number of sides stands for
/// "none".
using Side = std::uint32_t;

struct Orientation {
    /// For every face, whether it must be reversed so that neighbours agree: the minority in each component,
    /// or, in a tie, the faces that disagree with the component's first.
    std::vector<bool> reversed;
    /// The first face that cannot agree with all its neighbours, if the surface is one-sided.
    std::optional<std::size_t> contradiction;
};

/// \param sides  number of sides of every face
/// \param twins  for every side, the one of the neighbour across its edge
/// \param agree  whether a side and its twin run in opposite directions
[[nodiscard]] Orientation findOrientation(std::size_t sides, const std::vector<Side>& twins,
                                          const std::function<bool(Side, Side)>& agree);

} // namespace qm
