/// \file Checking the contract of a layout, using only the mesh and the layout's own lists.
#pragma once

#include "layout/layout.h"
#include "support/track_along.h"

#include <string>
#include <vector>

namespace qm::test {

/// Looks for an edge on two tracks, a track on the mesh boundary, a segment whose faces, vertices, corners
/// and sides do not form one grid or are not bordered by tracks and boundary only, a quad in no segment or in
/// two, segments in the wrong order, and a wrong cost.
/// \return the first fault; empty if there is none
[[nodiscard]] std::string layoutFault(const QuadMesh& mesh, const Layout& layout);

/// The vertices of every track but transversals. Expects a layout without faults.
[[nodiscard]] std::vector<Path> soundPaths(const QuadMesh& mesh, const Layout& layout);

} // namespace qm::test
