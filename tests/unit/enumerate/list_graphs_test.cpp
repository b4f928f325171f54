// Lists of graphs contain each graph once, in the same order for any number of threads, and end when asked.
#include "cli/tools/graph_line.h"
#include "enumerate/enumerate.h"
#include "support/polycube.h"
#include "support/random_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

namespace qm::test {
namespace {

class ListGraphs : public ::testing::Test {
protected:
    /// \return false if the list was ended early
    bool list(unsigned jobs, ListedGraphs which, GraphListing listing, std::function<bool()> stop = {}) {
        Control control;
        control.jobs = jobs;
        if (stop) control.stopRequested = std::move(stop);
        if (!listing.append)
            listing.append = [this](SubMeshId subMesh, const MotorcycleGraph& graph, std::string& text) {
                appendGraphLine(mesh, separatrices, subMesh, graph, text);
            };
        return listGraphs({mesh, complex, angles, {}, {}}, options, which, listing, control);
    }

    std::string listed(unsigned jobs, ListedGraphs which) {
        std::string all;
        std::size_t graphs = 0;
        EXPECT_TRUE(list(jobs, which, {{}, [&](std::string_view text, std::size_t count) {
                                           all += text;
                                           graphs += count;
                                           return true;
                                       }}));
        EXPECT_EQ(graphs, static_cast<std::size_t>(std::ranges::count(all, '\n')));
        return all;
    }

    QuadMesh mesh = quadMesh(polycube(bump(), 2));
    BaseComplex complex = buildBaseComplex(mesh);
    SeparatrixIndex separatrices{mesh, complex};
    std::vector<double> angles = dihedralAngles(mesh);
    EnumerationOptions options;
};

TEST_F(ListGraphs, TheOrderDoesNotDependOnThreads) {
    options.best = 500;
    for (const ListedGraphs which : {ListedGraphs::every, ListedGraphs::best}) {
        const std::string one = listed(1, which);
        EXPECT_GT(std::ranges::count(one, '\n'), 300); // several batches
        for (const unsigned jobs : {2U, 5U})
            EXPECT_EQ(listed(jobs, which), one);
    }
}

TEST_F(ListGraphs, LinesAreThoseOfDocuments) {
    options.best = 3;
    const Enumeration found = enumerateGraphs({mesh, complex, angles, {}, {}}, options);
    const BaseComplex none; // with it, every track would seem to begin at a source of its own
    for (const SeparatrixIndex& index : {separatrices, SeparatrixIndex(mesh, none)})
        for (const MotorcycleGraph& graph : found.subMeshes.front().graphs) {
            Json line{{"subMesh", 7}};
            line.update(graphToJson(mesh, index, graph));
            std::string text = "before ";
            appendGraphLine(mesh, index, SubMeshId(7), graph, text);
            EXPECT_EQ(text, "before " + printJsonLine(line));
        }
}

TEST_F(ListGraphs, EndsWhenTheTakerHasEnough) {
    for (const unsigned jobs : {1U, 3U}) {
        int taken = 0;
        EXPECT_FALSE(list(jobs, ListedGraphs::every,
                          {{}, [&](std::string_view, std::size_t) { return ++taken < 2; }}));
        EXPECT_EQ(taken, 2);
    }
}

TEST_F(ListGraphs, HandsFailuresOn) {
    for (const unsigned jobs : {1U, 3U}) {
        EXPECT_THROW(
            list(jobs, ListedGraphs::every,
                 {{}, [](std::string_view, std::size_t) -> bool { throw std::runtime_error("full"); }}),
            std::runtime_error);
        EXPECT_THROW(
            list(jobs, ListedGraphs::every,
                 {[](SubMeshId, const MotorcycleGraph&, std::string&) { throw std::runtime_error("bad"); },
                  [](std::string_view, std::size_t) { return true; }}),
            std::runtime_error);
    }
}

TEST_F(ListGraphs, HasTheSubMeshesOfItsPartOnly) {
    options.part = {1, 2};
    EXPECT_FALSE(listed(1, ListedGraphs::every).empty());
    options.part = {2, 2};
    EXPECT_TRUE(listed(1, ListedGraphs::every).empty());
}

TEST_F(ListGraphs, AsksWhetherToStopThroughout) {
    for (const ListedGraphs which : {ListedGraphs::every, ListedGraphs::best}) {
        EXPECT_FALSE(
            list(2, which, {{}, [](std::string_view, std::size_t) { return true; }}, [] { return true; }));
    }
}

} // namespace
} // namespace qm::test
