#include "check/tracks/lines.h"

#include "base/at.h"

#include <cmath>

namespace qm::check {

namespace {

class Tracer {
public:
    Tracer(const Neighbourhoods& around, const TraceInput& input)
        : around_(around), input_(input), seedStep_(at(around.vertices()), -1),
          covered_(at(around.steps()), 0), reached_(at(around.steps()), 0),
          visitedBy_(at(around.vertices()), -1), crossing_(at(around.vertices()), -1),
          junction_(at(around.vertices()), 0), networks_(at(input.subMeshes)) {
        for (const int step : input.seedSteps)
            seedStep_[at(around.from(step))] = step;
    }

    std::vector<LineNetwork> run() {
        for (int vertex = 0; vertex < around_.vertices(); ++vertex)
            traceFrom(vertex);
        for (int vertex = 0; vertex < around_.vertices(); ++vertex)
            noteCrossing(vertex);
        for (LineNetwork& network : networks_)
            finish(network);
        return std::move(networks_);
    }

private:
    [[nodiscard]] int label(int vertex) const {
        return input_.labels.empty() ? 0 : input_.labels[at(vertex)];
    }

    /// True if a particle starts at the step's first vertex and takes this step.
    [[nodiscard]] bool isFirstStep(int step) const {
        const int vertex = around_.from(step);
        if (around_.boundary(step)) return false;
        if (!around_.regular(vertex)) return true;
        const int seed = seedStep_[at(vertex)];
        return seed >= 0 && (step == seed || step == around_.turn(seed, 2));
    }

    void traceFrom(int vertex) {
        for (int step = around_.firstStep(vertex); step < around_.firstStep(vertex) + around_.valence(vertex);
             ++step)
            if (isFirstStep(step)) trace(step, label(vertex));
    }

    void trace(int step, int subMesh) {
        LineNetwork& network = networks_[at(subMesh)];
        network.wayByFirstStep.emplace(step, static_cast<int>(network.ways.size()));
        Way way;
        const int mark = ways_++;
        visitedBy_[at(around_.from(step))] = mark;
        while (true) {
            way.steps.push_back(step);
            covered_[at(step)] = 1;
            const int reached = around_.to(step);
            const bool inside = label(reached) == subMesh;
            if (inside) covered_[at(around_.back(step))] = 1;
            if (way.reach == 0) {
                reached_[at(step)] = 1;
                if (inside) reached_[at(around_.back(step))] = 1;
                // An end at the own source is an end like any other.
                const bool twice = visitedBy_[at(reached)] == mark && around_.passable(reached);
                if (twice) way.reach = static_cast<int>(way.steps.size());
                visitedBy_[at(reached)] = mark;
            }
            if (!inside) break;
            if (!around_.passable(reached) || isFirstStep(around_.back(step))) break;
            step = around_.straightOn(step);
        }
        if (way.reach == 0) way.reach = static_cast<int>(way.steps.size());
        network.ways.push_back(std::move(way));
    }

    /// Coverage counts only ways of the vertex's own sub-mesh: others end at the first vertex outside theirs.
    void noteCrossing(int vertex) {
        if (!around_.passable(vertex)) return;
        const int first = around_.firstStep(vertex);
        int covered = 0;
        int reached = 0;
        for (int step = first; step < first + 4; ++step) {
            covered += covered_[at(step)];
            reached += reached_[at(step)];
        }
        LineNetwork& network = networks_[at(label(vertex))];
        junction_[at(vertex)] = reached >= 3;
        network.ordinaryJunctions += reached >= 3;
        if (covered < 4) return;
        auto& crossings = network.crossings;
        crossing_[at(vertex)] = static_cast<int>(crossings.size());
        crossings.push_back({vertex, {}, seedStep_[at(vertex)] >= 0});
    }

    void finish(LineNetwork& network) const {
        for (std::size_t w = 0; w < network.ways.size(); ++w) {
            Way& way = network.ways[w];
            const int source = around_.from(way.steps.front());
            const int last = around_.back(way.steps.back());
            if (label(around_.from(last)) == label(source)) {
                const auto opposite = network.wayByFirstStep.find(last);
                if (opposite != network.wayByFirstStep.end()) way.opposite = opposite->second;
            }
            for (std::size_t walked = 1; walked < way.steps.size(); ++walked) {
                const int arrival = around_.back(way.steps[walked - 1]);
                const int vertex = around_.from(arrival);
                const bool withinReach = static_cast<int>(walked) < way.reach;
                if (withinReach && junction_[at(vertex)]) ++way.candidateStops;
                const int crossing = crossing_[at(vertex)];
                if (crossing < 0) continue;
                way.stops.push_back(crossing);
                way.stopSteps.push_back(static_cast<int>(walked));
                network.crossings[at(crossing)].from[at(arrival - around_.firstStep(vertex))] = {
                    static_cast<int>(w), static_cast<int>(way.stops.size())};
            }
        }
    }

    const Neighbourhoods& around_;
    const TraceInput& input_;
    std::vector<int> seedStep_;  ///< by vertex; -1 for none
    std::vector<char> covered_;  ///< by step
    std::vector<char> reached_;  ///< by step: covered before its line has crossed itself
    std::vector<int> visitedBy_; ///< by vertex: the last way that came
    std::vector<int> crossing_;  ///< by vertex, in its own sub-mesh
    std::vector<char> junction_; ///< by vertex: counts in n_j
    int ways_ = 0;
    std::vector<LineNetwork> networks_;
};

} // namespace

std::vector<LineNetwork> traceLines(const Neighbourhoods& around, const TraceInput& input) {
    return Tracer(around, input).run();
}

Meeting meetingAt(const LineNetwork& network, int way, int x) {
    const Crossing& crossing = network.crossings[at(network.ways[at(way)].stops[at(x) - 1])];
    std::size_t side = 0;
    while (crossing.from[side].way != way || crossing.from[side].coordinate != x)
        ++side;
    return {&crossing, side};
}

double quasiComplexity(const LineNetwork& network) {
    double sum = 0;
    for (const Way& way : network.ways)
        sum += std::log2(way.candidateStops);
    return sum;
}

} // namespace qm::check
