#include "check/tracks/sourceless.h"

#include "base/at.h"
#include "base/sort_unique.h"

#include <algorithm>

namespace qm::check {

std::vector<int> sourcelessComponents(const Neighbourhoods& around, const LineNetwork& network) {
    std::vector<char> source(at(around.vertices()), 0);
    for (const Way& way : network.ways)
        source[at(around.from(way.steps.front()))] = 1;
    std::vector<int> component(at(around.vertices()), -2);
    std::vector<int> reached;
    for (int start = 0; start < around.vertices(); ++start) {
        if (component[at(start)] != -2) continue;
        reached.assign(1, start);
        component[at(start)] = start;
        bool any = false;
        for (std::size_t next = 0; next < reached.size(); ++next) {
            const int vertex = reached[next];
            any = any || source[at(vertex)];
            for (int i = 0; i < around.valence(vertex); ++i) {
                const int other = around.to(around.firstStep(vertex) + i);
                if (component[at(other)] != -2) continue;
                component[at(other)] = start;
                reached.push_back(other);
            }
        }
        if (any)
            for (const int vertex : reached)
                component[at(vertex)] = -1;
    }
    return component;
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
    std::stable_sort(tracks.begin(), tracks.end(),
                     [&](const ReadTrack& a, const ReadTrack& b) { return componentOf(a) < componentOf(b); });
    for (std::size_t begin = 0, end = 0; begin < tracks.size(); begin = end) {
        std::vector<int> edges;
        for (; end < tracks.size() && componentOf(tracks[end]) == componentOf(tracks[begin]); ++end)
            for (const int step : tracks[end].steps)
                edges.push_back(around.edge(step));
        std::sort(edges.begin(), edges.end());
        if (edges != wholeLine(around, tracks[begin].steps.front()))
            report.violate(
                below(pointer, tracks[begin].rank), "whole line",
                "no particle starts in this component, and its tracks are not one whole mesh line");
    }
}

} // namespace qm::check
