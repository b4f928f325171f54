#include "check/tracks/check_transversals.h"

#include "base/at.h"
#include "check/tracks/paths.h"

#include <vector>

namespace qm::check {

namespace {

/// By vertex: how many tracks visit it.
std::vector<int> countVisits(const Neighbourhoods& around, std::span<const ReadTrack> tracks) {
    std::vector<int> visits(at(around.vertices()), 0);
    for (const ReadTrack& track : tracks) {
        for (const int step : track.steps)
            ++visits[at(around.from(step))];
        ++visits[at(around.to(track.steps.back()))];
    }
    return visits;
}

/// \param path  the pointer of its vertices
void checkTransversal(const Neighbourhoods& around, const ReadTrack& track, const std::vector<int>& visits,
                      const std::string& path, Report& report) {
    const std::size_t bend = firstBend(around, track.steps);
    if (bend < track.steps.size())
        return report.violate(below(path, bend + 1), "transversal straight",
                              "it does not go straight on to this vertex");
    for (const int step : track.steps)
        if (around.boundary(step))
            return report.violate(path, "transversal inside", "it runs along the mesh boundary");
    for (std::size_t i = 0; i <= track.steps.size(); ++i) {
        const bool end = i == 0 || i == track.steps.size();
        const int vertex = end && i > 0 ? around.to(track.steps.back()) : around.from(track.steps[i]);
        const bool other = visits[at(vertex)] > 1 || !around.interior(vertex);
        if (other != end)
            report.violate(below(path, i), "transversal ends",
                           end ? "it ends on no other track and not on the boundary"
                               : "it meets another track before its end");
    }
}

} // namespace

void checkTransversals(const Neighbourhoods& around, std::span<const ReadTrack> tracks,
                       std::span<const ReadTrack> transversals, const std::string& pointer, Report& report) {
    const std::vector<int> visits = countVisits(around, tracks);
    for (const ReadTrack& track : transversals)
        checkTransversal(around, track, visits, below(pointer, track.rank, "vertices"), report);
}

} // namespace qm::check
