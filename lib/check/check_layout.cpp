#include "base/at.h"
#include "base/number_text.h"
#include "check/check_constraints.h"
#include "check/check_graph.h"
#include "check/check_sections.h"
#include "check/check_segments.h"
#include "check/paths.h"

#include <algorithm>
#include <unordered_set>

namespace qm::check {

namespace {

constexpr const char* tracksPlace = "/layout/tracks";

/// By vertex: the lowest vertex of its component if no particle starts in the component, else -1.
std::vector<int> componentsWithoutSource(const Neighbourhoods& around, const LineNetwork& network) {
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

/// The edges of the whole mesh line of a step, ascending: round to the step again, or to the boundary both
/// ways.
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
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
}

class LayoutCheck {
public:
    LayoutCheck(const Context& context, const LineNetwork& network, const LayoutPart& part, Report& report)
        : context_(context), around_(context.around), network_(network), part_(part), report_(report),
          sourceless_(componentsWithoutSource(around_, network)), onTrack_(at(around_.edges()), 0) {}

    void run() {
        auto tracks = readTracks(around_, part_.tracks, tracksPlace, report_);
        ids();
        for (const int edge : edgesOf(around_, tracks, tracksPlace, report_))
            onTrack_[at(edge)] = 1;
        prices(tracks);

        const auto notTransversal =
            std::stable_partition(tracks.begin(), tracks.end(),
                                  [&](const ReadTrack& t) { return part_.tracks[t.rank].transversal; });
        const std::span transversals(tracks.begin(), notTransversal);
        const auto ordinary = std::stable_partition(notTransversal, tracks.end(), [&](const ReadTrack& t) {
            return sourceless_[at(around_.from(t.steps.front()))] >= 0;
        });
        wholeLines(std::span(notTransversal, ordinary));
        particles(std::span(ordinary, tracks.end()));
        for (const ReadTrack& track : tracks)
            countVisits(track);
        for (const ReadTrack& track : transversals)
            transversal(track);
        checkConstraints(around_, context_.constraints, onTrack_, true, tracksPlace, report_);
        checkFront(part_, report_);
        const std::size_t before = report_.total();
        if (part_.divided) checkSegments(context_.mesh, around_, onTrack_, part_, report_);
        if (report_.total() == before) checkQuality(around_, context_.angles, onTrack_, part_, report_);
    }

private:
    void ids() {
        std::unordered_set<int> seen;
        for (std::size_t i = 0; i < part_.tracks.size(); ++i)
            if (part_.tracks[i].id && !seen.insert(*part_.tracks[i].id).second)
                report_.violate(below(below(tracksPlace, i), "id"), "id", "another track has it too");
    }

    void prices(std::span<const ReadTrack> tracks) {
        CostSum total(context_.costs);
        for (const ReadTrack& track : tracks) {
            CostSum cost(context_.costs);
            for (const int step : track.steps)
                cost.add(around_.edge(step));
            if (!part_.tracks[track.rank].transversal) total.add(cost);
            const auto& claimed = part_.tracks[track.rank].cost;
            if (claimed && !cost.equals(*claimed))
                report_.violate(below(below(tracksPlace, track.rank), "cost"), "cost",
                                "its edges cost " + numberText(cost.value()));
        }
        if (part_.cost && !total.equals(*part_.cost))
            report_.violate("/layout/cost", "G_T",
                            "the edges of the tracks cost " + numberText(total.value()));
        // A pruned layout may cost less than any motorcycle graph.
        if (part_.lowerBound && !part_.pruned && !total.equals(*part_.lowerBound) &&
            !(*part_.lowerBound <= total.value()))
            report_.violate("/layout/lowerBound", "bound", "it is above the cost");
    }

    void particles(std::span<const ReadTrack> tracks) {
        if (part_.pruned) {
            for (const ReadTrack& track : tracks)
                straight(track);
        } else {
            std::vector<char> present(onTrack_.size(), 0);
            std::size_t count = 0;
            for (const ReadTrack& track : tracks)
                for (const int step : track.steps) {
                    char& edge = present[at(around_.edge(step))];
                    count += edge == 0;
                    edge = 1;
                }
            checkGraph(around_, network_, tracks, present, count, part_.tmesh, tracksPlace, report_);
        }
    }

    /// What pruning leaves may begin and end anywhere; the segments tell whether that is right.
    void straight(const ReadTrack& track) {
        const std::string path = below(below(tracksPlace, track.rank), "vertices");
        for (std::size_t k = 0; k < track.steps.size(); ++k) {
            if (around_.boundary(track.steps[k]))
                return report_.violate(below(path, k), "track inside",
                                       "the track runs along the mesh boundary from here");
            if (k + 1 == track.steps.size()) return;
            const int vertex = around_.to(track.steps[k]);
            if (!around_.passable(vertex) || around_.straightOn(track.steps[k]) != track.steps[k + 1])
                return report_.violate(below(path, k + 1), "track straight",
                                       "the track does not go straight on at vertex " +
                                           std::to_string(vertex));
        }
    }

    /// Where no particle starts, the tracks of a component are those of one line.
    void wholeLines(std::span<ReadTrack> tracks) {
        const auto componentOf = [&](const ReadTrack& t) {
            return sourceless_[at(around_.from(t.steps.front()))];
        };
        std::stable_sort(tracks.begin(), tracks.end(), [&](const ReadTrack& a, const ReadTrack& b) {
            return componentOf(a) < componentOf(b);
        });
        for (std::size_t begin = 0, end = 0; begin < tracks.size(); begin = end) {
            std::vector<int> edges;
            for (; end < tracks.size() && componentOf(tracks[end]) == componentOf(tracks[begin]); ++end)
                for (const int step : tracks[end].steps)
                    edges.push_back(around_.edge(step));
            std::sort(edges.begin(), edges.end());
            if (edges != wholeLine(around_, tracks[begin].steps.front()))
                report_.violate(
                    below(tracksPlace, tracks[begin].rank), "whole line",
                    "no particle starts in this component, and its tracks are not one whole mesh line");
        }
    }

    void countVisits(const ReadTrack& track) {
        visits_.resize(at(around_.vertices()), 0);
        for (const int step : track.steps)
            ++visits_[at(around_.from(step))];
        ++visits_[at(around_.to(track.steps.back()))];
    }

    /// From one track or boundary to another, straight, and clear of tracks between.
    void transversal(const ReadTrack& track) {
        const std::string path = below(below(tracksPlace, track.rank), "vertices");
        const std::size_t bend = firstBend(around_, track.steps);
        if (bend < track.steps.size()) {
            report_.violate(below(path, bend + 1), "transversal straight",
                            "it does not go straight on to this vertex");
            return;
        }
        for (const int step : track.steps)
            if (around_.boundary(step)) {
                report_.violate(path, "transversal inside", "it runs along the mesh boundary");
                return;
            }
        for (std::size_t i = 0; i <= track.steps.size(); ++i) {
            const bool end = i == 0 || i == track.steps.size();
            const int vertex = end && i > 0 ? around_.to(track.steps.back()) : around_.from(track.steps[i]);
            const bool other = visits_[at(vertex)] > 1 || !around_.interior(vertex);
            if (other != end)
                report_.violate(below(path, i), "transversal ends",
                                end ? "it ends on no other track and not on the boundary"
                                    : "it meets another track before its end");
        }
    }

    const Context& context_;
    const Neighbourhoods& around_;
    const LineNetwork& network_;
    const LayoutPart& part_;
    Report& report_;
    std::vector<int> sourceless_; ///< by vertex
    std::vector<char> onTrack_;   ///< by edge
    std::vector<int> visits_;     ///< by vertex, by all tracks
};

} // namespace

void checkLayout(const Context& context, const LineNetwork& network, const LayoutPart& part, Report& report) {
    LayoutCheck(context, network, part, report).run();
}

} // namespace qm::check
