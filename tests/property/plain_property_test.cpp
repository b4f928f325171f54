// Checks the plain motorcycle graph of random meshes against rules A1 to A4 and the arc rules.
#include "base/at.h"
#include "check/mesh/neighbourhoods.h"
#include "check/tracks/check_graph.h"
#include "enumerate/paper/plain_graph.h"
#include "support/random_graph.h"

#include <gtest/gtest.h>

namespace qm::test {
namespace {

std::vector<check::ReadTrack> read(const QuadMesh& mesh, const check::Neighbourhoods& around,
                                   const std::vector<Track>& tracks) {
    std::vector<check::ReadTrack> result;
    for (const Track& track : tracks) {
        result.push_back({result.size(), {}});
        for (const HalfedgeId halfedge : track.halfedges)
            result.back().steps.push_back(around.stepBetween(mesh.from_vertex_handle(halfedge).idx(),
                                                             mesh.to_vertex_handle(halfedge).idx()));
    }
    return result;
}

/// All rules that the graph breaks, one per line.
std::string brokenRules(const QuadMesh& mesh, const std::vector<Seed>& seeds,
                        const std::vector<Track>& tracks) {
    const check::Neighbourhoods around(check::checkedMesh(mesh));
    check::TraceInput input;
    for (const Seed& seed : seeds)
        input.seedSteps.push_back(around.stepBetween(mesh.from_vertex_handle(seed.direction).idx(),
                                                     mesh.to_vertex_handle(seed.direction).idx()));
    const std::vector<check::ReadTrack> paths = read(mesh, around, tracks);
    check::Report report;
    std::vector<char> present(static_cast<std::size_t>(around.edges()), 0);
    const std::vector<int> edges = check::edgesOf(around, paths, "", report);
    for (const int edge : edges)
        present[at(edge)] = 1;
    check::checkGraph(around, check::traceLines(around, input).front(), {"", paths, present, edges.size()},
                      false, report);
    std::string text;
    for (const check::Violation& violation : report.violations())
        text += violation.rule + ": " + violation.explanation + "\n";
    return text;
}

TEST(PlainGraphProperty, ObeysEveryRule) {
    std::size_t met = 0;
    for (unsigned number = 0; number < 2000; ++number) {
        std::mt19937 random(number);
        const std::optional<QuadMesh> mesh = randomMesh(random);
        if (!mesh) continue;
        const std::vector<Seed> seeds = randomSeeds(*mesh, 3, random);
        const std::vector<double> costs(mesh->n_edges(), 1);
        const MotorcycleGraph graph = plainMotorcycleGraph(*mesh, buildBaseComplex(*mesh, seeds), costs);
        ASSERT_EQ(brokenRules(*mesh, seeds, graph.tracks), "") << "case " << number;
        double cost = 0;
        for (const Track& track : graph.tracks) {
            EXPECT_EQ(track.cost, static_cast<double>(track.halfedges.size()));
            cost += track.cost;
        }
        EXPECT_EQ(graph.cost, cost);
        ++met;
    }
    EXPECT_GT(met, 800U);
}

} // namespace
} // namespace qm::test
