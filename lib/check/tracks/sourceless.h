/// \file Components in which no particle starts: their layout is one whole mesh line (docs/METHOD.md#layout).
#pragma once

#include "check/document/report.h"
#include "check/mesh/neighbourhoods.h"
#include "check/tracks/check_graph.h"
#include "check/tracks/lines.h"

#include <span>
#include <string>
#include <vector>

namespace qm::check {

/// By vertex: the lowest vertex of its component if no particle starts in the component, else -1.
/// \param network  the lines of the whole mesh
[[nodiscard]] std::vector<int> sourcelessComponents(const Neighbourhoods& around, const LineNetwork& network);

/// The edges of the whole mesh line of a step, ascending: round to the step again, or to the boundary both
/// ways.
[[nodiscard]] std::vector<int> wholeLine(const Neighbourhoods& around, int step);

/// Reports components whose tracks are not together one whole mesh line.
/// \param component  by vertex, see `sourcelessComponents`
/// \param tracks     all that lie in components without sources; they are reordered
/// \param pointer    of the list of tracks
void checkWholeLines(const Neighbourhoods& around, const std::vector<int>& component,
                     std::span<ReadTrack> tracks, const std::string& pointer, Report& report);

} // namespace qm::check
