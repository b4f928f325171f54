/// \file Is a layout what its contract says? Tried with nothing but the mesh and the lists in the layout.
#pragma once

#include "layout/layout.h"

#include <string>
#include <vector>

namespace qm::testing {

/// Looks for an edge on two tracks, a track on the mesh boundary, a segment whose faces, vertices, corners
/// and sides are not one grid or not bordered by tracks and the boundary alone, a quad in no segment or in
/// two, segments out of order, and a wrong cost.
/// \return the first fault, empty if there is none
[[nodiscard]] std::string layoutFault(const QuadMesh& mesh, const Layout& layout);

/// The tracks that are no transversals.
[[nodiscard]] std::vector<Track> properTracks(const Layout& layout);

} // namespace qm::testing
