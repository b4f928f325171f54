#include "check/tracks/sourceless.h"

#include "base/at.h"
#include "base/disjoint_sets.h"
#include "base/groups.h"
#include "base/sort_unique.h"

#include <algorithm>

namespace qm::check {

std::vector<int> sourcelessComponents(const Neighbourhoods& around, const LineNetwork& network) {
    DisjointSets components(at(around.vertices()));
    for (int step = 0; step < around.steps(); ++step)
        components.join(at(around.from(step)), at(around.to(step)));
    std::vector<char> hasSource(at(around.vertices()), 0);
    for (const Way& way : network.ways)
        hasSource[components.find(at(around.from(way.steps.front())))] = 1;
    std::vector<int> result;
    for (std::size_t vertex = 0; vertex < hasSource.size(); ++vertex) {
        const std::size_t lowest = components.find(vertex);
        result.push_back(hasSource[lowest] ? -1 : static_cast<int>(lowest));
    }
    return result;
}

std::vector<int> wholeLine(const Neighbourhoods& around, int first) {
    std::vector<int> edges;
    for (const int start : {first, around.back(first)}) {
        int step = start;
        bool closed = false;
        while (true) {
            edges.push_back(around.edge(step));
            if (!around.passable(around.to(step))) break;
            step = around.straightOn(step);
            closed = step == start;
            if (closed) break;
        }
        if (closed) break;
    }
    sortUnique(edges);
    return edges;
}

void checkWholeLines(const Neighbourhoods& around, const std::vector<int>& component,
                     std::span<ReadTrack> tracks, const std::string& pointer, Report& report) {
    const auto componentOf = [&](const ReadTrack& track) {
        return component[at(around.from(track.steps.front()))];
    };
    std::ranges::stable_sort(tracks, {}, componentOf);
    forEachGroup(tracks, componentOf, [&](std::span<const ReadTrack> together) {
        std::vector<int> edges;
        for (const ReadTrack& track : together)
            for (const int step : track.steps)
                edges.push_back(around.edge(step));
        std::ranges::sort(edges);
        if (edges != wholeLine(around, together.front().steps.front()))
            report.violate(
                below(pointer, together.front().rank), "whole line",
                "no particle starts in this component, and its tracks are not one whole mesh line");
    });
}

} // namespace qm::check
