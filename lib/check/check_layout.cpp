#include "base/at.h"
#include "base/number_text.h"
#include "base/positions.h"
#include "check/check_sections.h"
#include "check/tracks/check_graph.h"
#include "check/tracks/check_segments.h"
#include "check/tracks/check_transversals.h"
#include "check/tracks/sourceless.h"

#include <algorithm>
#include <unordered_set>

namespace qm::check {

namespace {

constexpr const char* tracksPlace = "/layout/tracks";

/// By vertex: its component if the tracks there must be one whole line together, else -1. In open components,
/// pruning also draws tracks from corners of the boundary.
std::vector<int> componentsOfOneLine(const Neighbourhoods& around, const LineNetwork& network,
                                     bool isPruned) {
    std::vector<int> component = sourcelessComponents(around, network);
    if (!isPruned) return component;
    std::unordered_set<int> open;
    for (int step = 0; step < around.steps(); ++step)
        if (around.boundary(step)) open.insert(component[at(around.from(step))]);
    for (int& lowest : component)
        if (open.contains(lowest)) lowest = -1;
    return component;
}

class LayoutCheck {
public:
    LayoutCheck(const Context& context, const LineNetwork& network, const LayoutPart& part, Report& report)
        : context_(context), around_(context.around), network_(network), part_(part), report_(report),
          ofOneLine_(componentsOfOneLine(around_, network, part.pruned)), onTrack_(at(around_.edges()), 0) {}

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
            return ofOneLine_[at(around_.from(t.steps.front()))] >= 0;
        });
        checkWholeLines(around_, ofOneLine_, std::span(notTransversal, ordinary), tracksPlace, report_);
        particles(std::span(ordinary, tracks.end()));
        checkTransversals(around_, tracks, transversals, tracksPlace, report_);
        constraints(std::span(notTransversal, tracks.end()));
        checkFront(part_, report_);
        const std::size_t before = report_.total();
        if (part_.divided) checkSegments(context_.mesh, around_, onTrack_, part_, report_);
        if (report_.total() == before) checkQuality(around_, context_.angles, onTrack_, part_, report_);
    }

private:
    /// By edge: whether it lies on one of these tracks.
    [[nodiscard]] std::vector<char> edgesOn(std::span<const ReadTrack> tracks) const {
        std::vector<char> present(onTrack_.size(), 0);
        for (const ReadTrack& track : tracks)
            for (const int step : track.steps)
                present[at(around_.edge(step))] = 1;
        return present;
    }

    void constraints(std::span<const ReadTrack> tracks) {
        checkConstraints(context_, edgesOn(tracks), GraphOf::mesh, tracksPlace, report_);
    }

    void ids() {
        std::unordered_set<int> seen;
        for (std::size_t i = 0; i < part_.tracks.size(); ++i)
            if (part_.tracks[i].id && !seen.insert(*part_.tracks[i].id).second)
                report_.violate(below(tracksPlace, i, "id"), "id", "another track has it too");
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
                report_.violate(below(tracksPlace, track.rank, "cost"), "cost",
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
            const std::vector<char> present = edgesOn(tracks);
            checkGraph(around_, network_, {tracksPlace, tracks, present, countIn(present, 1)}, part_.tmesh,
                       report_);
        }
    }

    /// What pruning leaves may begin and end anywhere; the segments tell whether that is right.
    void straight(const ReadTrack& track) {
        const std::string path = below(tracksPlace, track.rank, "vertices");
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

    const Context& context_;
    const Neighbourhoods& around_;
    const LineNetwork& network_;
    const LayoutPart& part_;
    Report& report_;
    std::vector<int> ofOneLine_; ///< by vertex
    std::vector<char> onTrack_;  ///< by edge
};

} // namespace

void checkLayout(const Context& context, const LineNetwork& network, const LayoutPart& part, Report& report) {
    LayoutCheck(context, network, part, report).run();
}

} // namespace qm::check
