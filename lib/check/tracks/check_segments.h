/// \file Do the segments tile the mesh as grids that end exactly at the tracks? (docs/METHOD.md#layout)
#pragma once

#include "check/document/checked_document.h"
#include "check/document/report.h"
#include "check/mesh/neighbourhoods.h"

#include <span>
#include <vector>

namespace qm::check {

/// Each segment is a grid of faces, listed row by row, with four corners and four sides that are its border;
/// every face lies in exactly one; the borders are the tracks and the mesh boundary, and nothing else.
/// \param onTrack  by edge
void checkSegments(const CheckedMesh& mesh, const Neighbourhoods& around, std::span<const char> onTrack,
                   const LayoutPart& part, Report& report);

/// The (a + 1) x (b + 1) vertices of a segment, row by row from corner 0 along side 0, as its faces give
/// them. Empty, with a report, if they form no grid.
[[nodiscard]] std::vector<int> gridOf(const CheckedMesh& mesh, const LayoutPart::Segment& segment,
                                      const std::string& pointer, Report& report);

/// The same for a segment that is known to be a grid.
[[nodiscard]] std::vector<int> soundGridOf(const CheckedMesh& mesh, const LayoutPart::Segment& segment);

} // namespace qm::check
