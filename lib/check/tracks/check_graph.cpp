#include "check/tracks/check_graph.h"

#include "base/at.h"
#include "base/positions.h"
#include "check/tracks/arc_rules.h"
#include "check/tracks/paths.h"
#include "check/tracks/track_rules.h"

#include <algorithm>

namespace qm::check {

namespace {

/// The coordinate after `steps` steps of the way; -1 between two stops.
int coordinateAfter(const Way& way, std::size_t steps) {
    if (steps == way.steps.size()) return way.length();
    const auto stop = std::ranges::lower_bound(way.stopSteps, static_cast<int>(steps));
    const bool found = stop != way.stopSteps.end() && at(*stop) == steps;
    return found ? static_cast<int>(stop - way.stopSteps.begin()) + 1 : -1;
}

void checkStraight(const Neighbourhoods& around, std::span<const ReadTrack> tracks,
                   const std::string& pointer, Report& report) {
    for (const ReadTrack& track : tracks)
        if (const std::size_t bend = firstBend(around, track.steps); bend < track.steps.size())
            report.violate(below(pointer, track.rank, "vertices", bend + 1), "track straight",
                           "it does not go straight on to this vertex");
}

/// The tracks as coordinates.
struct Coordinates {
    std::vector<int> x;       ///< arcs walked on every way of the network; 0 without a track
    std::vector<int> trackOf; ///< rank of every way's track; -1 without
    bool sound = true;        ///< every track ends at a stop of its own way
};

/// Reports every track that is no beginning of a separatrix, or shares its separatrix with another, or
/// ends where no line crosses.
Coordinates coordinatesOf(const Neighbourhoods& around, const LineNetwork& network,
                          std::span<const ReadTrack> tracks, const std::string& pointer, Report& report) {
    Coordinates found{std::vector<int>(network.ways.size(), 0), std::vector<int>(network.ways.size(), -1),
                      true};
    const auto unsound = [&](const std::string& place, const char* rule, std::string explanation) {
        report.violate(place, rule, std::move(explanation));
        found.sound = false;
    };
    for (const ReadTrack& track : tracks) {
        const std::string here = below(pointer, track.rank);
        const std::string path = below(here, "vertices");
        const auto start = network.wayByFirstStep.find(track.steps.front());
        if (start == network.wayByFirstStep.end()) {
            unsound(below(path, 0), "track start",
                    "no particle starts at vertex " + std::to_string(around.from(track.steps.front())) +
                        " this way");
            continue;
        }
        const Way& way = network.ways[at(start->second)];
        const auto [leaves, expected] =
            std::mismatch(track.steps.begin(), track.steps.end(), way.steps.begin(), way.steps.end());
        if (leaves != track.steps.end()) {
            unsound(below(path, positionIn(track.steps, leaves) + 1), "track straight",
                    expected == way.steps.end() ? "the separatrix ends before this vertex"
                                                : "the track leaves its separatrix at this vertex");
            continue;
        }
        const int x = coordinateAfter(way, track.steps.size());
        if (x < 0)
            unsound(below(path, track.steps.size()), "A4",
                    "it ends where no line crosses, and nothing stops it");
        if (found.trackOf[at(start->second)] >= 0)
            unsound(here, "track twice",
                    "the same particle's as track " + std::to_string(found.trackOf[at(start->second)]));
        found.trackOf[at(start->second)] = static_cast<int>(track.rank);
        found.x[at(start->second)] = x;
    }
    return found;
}

void checkParticles(const Neighbourhoods& around, const LineNetwork& network,
                    std::span<const ReadTrack> tracks, const std::string& pointer, Report& report) {
    const Coordinates coordinates = coordinatesOf(around, network, tracks, pointer, report);
    if (!coordinates.sound) return;
    for (const BrokenTrackRule& broken : brokenTrackRules(network, coordinates.x)) {
        const int track = coordinates.trackOf[at(broken.way)];
        const int first = network.ways[at(broken.way)].steps.front();
        const std::string particle = "the particle from vertex " + std::to_string(around.from(first)) +
                                     " over vertex " + std::to_string(around.to(first)) + ": ";
        report.violate(track < 0 ? pointer : below(pointer, at(track)), broken.rule,
                       particle + broken.explanation);
    }
}

} // namespace

std::vector<ReadTrack> readTracks(const Neighbourhoods& around, const std::vector<TrackPart>& tracks,
                                  const std::string& pointer, Report& report) {
    std::vector<ReadTrack> read;
    read.reserve(tracks.size());
    for (std::size_t i = 0; i < tracks.size(); ++i)
        if (auto steps = readPath(around, tracks[i].vertices, below(pointer, i, "vertices"), report))
            read.push_back({i, std::move(*steps)});
    return read;
}

std::vector<int> edgesOf(const Neighbourhoods& around, std::span<const ReadTrack> tracks,
                         const std::string& pointer, Report& report) {
    std::vector<std::pair<int, std::size_t>> edges;
    for (const ReadTrack& track : tracks)
        for (const int step : track.steps)
            edges.emplace_back(around.edge(step), track.rank);
    std::ranges::sort(edges);
    std::vector<int> result;
    result.reserve(edges.size());
    for (std::size_t i = 0; i < edges.size(); ++i) {
        if (i > 0 && edges[i].first == edges[i - 1].first)
            report.violate(below(pointer, edges[i].second), "edge twice",
                           "an edge of it lies also on track " + std::to_string(edges[i - 1].second));
        else
            result.push_back(edges[i].first);
    }
    return result;
}

void checkGraph(const Neighbourhoods& around, const LineNetwork& network, const ReadGraph& graph,
                bool isTMesh, Report& report) {
    if (isTMesh)
        checkStraight(around, graph.tracks, graph.pointer, report);
    else
        checkParticles(around, network, graph.tracks, graph.pointer, report);
    const ArcRuleSet rules = isTMesh ? ArcRuleSet::ofTMeshes : ArcRuleSet::ofGraphs;
    for (const BrokenArcRule& broken : brokenArcRules(around, network, graph.present, graph.count, rules))
        report.violate(graph.pointer, broken.rule, broken.explanation);
}

} // namespace qm::check
