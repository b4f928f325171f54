/// \file Is a list of tracks a motorcycle graph? (docs/METHOD.md#valid-tracks)
#pragma once

#include "check/document/checked_document.h"
#include "check/document/report.h"
#include "check/tracks/lines.h"

#include <span>
#include <string>
#include <vector>

namespace qm::check {

/// A track of the document whose vertices have proved to be a path.
struct ReadTrack {
    std::size_t rank = 0;   ///< in the document's list
    std::vector<int> steps; ///< at least one
};

/// Reads the paths of all tracks and reports those that are none.
/// \param pointer  of the list
[[nodiscard]] std::vector<ReadTrack> readTracks(const Neighbourhoods& around,
                                                const std::vector<TrackPart>& tracks,
                                                const std::string& pointer, Report& report);

/// The edges of the tracks, ascending; reports each that lies on two.
[[nodiscard]] std::vector<int> edgesOf(const Neighbourhoods& around, std::span<const ReadTrack> tracks,
                                       const std::string& pointer, Report& report);

/// The tracks of a graph, and the edges that they cover.
struct ReadGraph {
    std::string pointer; ///< of the list of tracks
    std::span<const ReadTrack> tracks;
    std::span<const char> present; ///< by edge: whether it lies on a track
    std::size_t count = 0;         ///< how many edges do
};

/// Tests the tracks by rules A1 to A4 and, apart from that, the set of their edges by the rules on arcs.
/// \param isTMesh  tracks may begin and end on others: they need only be straight and obey arc rules 1 and 2
void checkGraph(const Neighbourhoods& around, const LineNetwork& network, const ReadGraph& graph,
                bool isTMesh, Report& report);

} // namespace qm::check
