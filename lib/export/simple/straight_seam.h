/// \file Straight edges between two faces of one cylinder or cone.
#pragma once

#include "export/simple/simple_surface.h"

#include <array>
#include <gp_Pnt.hxx>
#include <optional>
#include <vector>

namespace qm {

/// Whether two surfaces are one cylinder, or one cone, but for where parameters begin.
/// \param resolution  closer points are taken for one
[[nodiscard]] bool areOneRuledSurface(const SimpleSurface& one, const SimpleSurface& other,
                                      double resolution);

/// Where the ends of an edge on a cylinder or cone would be if it were straight: on the line of the surface
/// half-way between them, and on all other surfaces that meet at the end.
/// \param others  at either end; if they do not meet on the line, the end is as near to that as it can be
/// \return nothing if the edge runs around the surface rather than along it
[[nodiscard]] std::optional<std::array<gp_Pnt, 2>>
straightened(const SimpleSurface& ruled, const std::array<gp_Pnt, 2>& ends,
             const std::array<std::vector<SimpleSurface>, 2>& others);

} // namespace qm
