// Compares the searches with each other and with trying everything, on random meshes with random seeds and
// costs.
#include "base/at.h"
#include "base/infinity.h"
#include "enumerate/diagram/count_and_draw.h"
#include "enumerate/diagram/walk.h"
#include "enumerate/optimum/optimum.h"
#include "enumerate/paper/coordinates.h"
#include "enumerate/paper/courses.h"
#include "enumerate/paper/plain_graph.h"
#include "enumerate/state/depth_first.h"
#include "enumerate/state/independent_parts.h"
#include "enumerate/sub_mesh/search_space.h"
#include "enumerate/window/window_search.h"
#include "layout/corners.h"
#include "layout/cost.h"
#include "layout/layout.h"
#include "layout/tracks.h"
#include "merge/generators.h"
#include "merge/improve.h"
#include "merge/merge.h"
#include "mesh/topology.h"
#include "shape/shape.h"
#include "support/random_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>

namespace qm::test {
namespace {

constexpr int cases = 150;
constexpr std::size_t maxGraphs = 20000;

struct Case {
    QuadMesh mesh;
    BaseComplex complex;
    std::vector<double> angles;
    std::vector<double> costs;
    ArcGraph graph;
    Problem problem;
};

/// A random case; nothing if the random choice is no mesh.
std::optional<Case> drawCase(unsigned number) {
    std::mt19937 random(number);
    std::optional<QuadMesh> mesh = randomMesh(random);
    if (!mesh) return std::nullopt;
    Case drawn;
    drawn.mesh = std::move(*mesh);
    std::uniform_real_distribution<double> angle(0, 1);
    for (std::size_t edge = 0; edge < drawn.mesh.n_edges(); ++edge)
        drawn.angles.push_back(angle(random));
    drawn.costs = edgeCosts(drawn.angles, {0.9, 0.7});
    drawn.complex = buildBaseComplex(drawn.mesh, randomSeeds(drawn.mesh, 2, random));
    drawn.graph = buildArcGraph(drawn.mesh, drawn.complex);
    const auto arcCosts = sumOverArcs(drawn.mesh, drawn.graph, drawn.complex, drawn.costs);
    drawn.problem = makeProblem({drawn.graph, arcCosts, {}, {}, {}, {}});
    return drawn;
}

PresentArcs presentIn(const Case& drawn, const Assignment& assignment) {
    PresentArcs present(drawn.graph.arcs.size(), false);
    apply(drawn.problem, assignment, present);
    return present;
}

/// All graphs found by the search; nothing if there are too many.
std::optional<std::set<Assignment>> allGraphs(const Problem& problem) {
    std::set<Assignment> graphs;
    bool twice = false;
    const bool finished = forEachAssignment(
        problem, [] { return infinity; },
        [&](const SearchState& state) {
            twice = twice || !graphs.insert(state.assignment()).second;
            return graphs.size() <= maxGraphs;
        });
    EXPECT_FALSE(twice) << "a graph was visited twice";
    return finished ? std::optional(graphs) : std::nullopt;
}

std::vector<double> sortedCosts(const Problem& problem, const std::set<Assignment>& graphs) {
    std::vector<double> costs;
    costs.reserve(graphs.size());
    for (const Assignment& graph : graphs)
        costs.push_back(costOf(problem, graph));
    std::ranges::sort(costs);
    return costs;
}

TEST(SearchProperty, EveryVisitedGraphIsValidAndCounted) {
    int tried = 0;
    for (unsigned number = 0; number < cases; ++number) {
        const auto drawn = drawCase(number);
        if (!drawn) continue;
        const auto graphs = allGraphs(drawn->problem);
        if (!graphs) continue;
        ++tried;
        for (const Assignment& graph : *graphs)
            ASSERT_TRUE(isMotorcycleGraph(drawn->graph, presentIn(*drawn, graph))) << "case " << number;
        EXPECT_EQ(countGraphs(drawn->problem), BigCount(graphs->size())) << "case " << number;
        EXPECT_EQ(countByParts(drawn->problem), BigCount(graphs->size())) << "case " << number;
    }
    EXPECT_GT(tried, cases / 4);
}

/// The mesh edges of a graph.
std::vector<bool> edgesOf(const Case& drawn, const Assignment& graph) {
    const PresentArcs present = presentIn(drawn, graph);
    std::vector<bool> edges(drawn.mesh.n_edges(), false);
    for (const ArcId arc : present.ids())
        for (const HalfedgeId halfedge : halfedgesOf(drawn.graph, drawn.complex, arc))
            if (present[arc]) edges[at(drawn.mesh.edge_handle(halfedge))] = true;
    return edges;
}

/// The number of corners of faces with a marked or boundary edge on both sides.
std::size_t countCorners(const QuadMesh& mesh, const std::vector<bool>& edges) {
    const auto bounds = [&](HalfedgeId halfedge) {
        const EdgeId edge = mesh.edge_handle(halfedge);
        return edges[at(edge)] || mesh.is_boundary(edge);
    };
    std::size_t corners = 0;
    for (const HalfedgeId halfedge : mesh.halfedges())
        if (!mesh.is_boundary(halfedge) && bounds(halfedge) && bounds(mesh.next_halfedge_handle(halfedge)))
            ++corners;
    return corners;
}

TEST(SearchProperty, CornersOfSegmentsAreThoseOfTheMesh) {
    int compared = 0;
    for (const bool gaps : {true, false})
        for (unsigned number = 0; number < cases; ++number) {
            auto drawn = drawCase(number);
            if (!drawn) continue;
            const SearchSpace space = makeSearchSpace(drawn->mesh, drawn->complex,
                                                      {std::vector(drawn->mesh.n_edges(), 0.0), 1}, {}, {});
            drawn->problem = subMeshProblem(space, SubMeshId(0), ownArcs(space, SubMeshId(0)),
                                            PresentArcs(space.graph.arcs.size()));
            drawn->problem.gaps = gaps;
            const auto graphs = allGraphs(drawn->problem);
            if (!graphs) continue;
            const SubMeshes whole;
            const Corners corners(drawn->mesh, whole);
            const std::vector<double> free(drawn->mesh.n_edges(), 0);
            const auto fixed = static_cast<double>(corners.fixed(SubMeshId(0)));
            for (const Assignment& graph : *graphs) {
                const auto all = static_cast<double>(countCorners(drawn->mesh, edgesOf(*drawn, graph)));
                ASSERT_NEAR(costOf(drawn->problem, graph) + fixed, all, 1e-9) << "case " << number;
                const PresentArcs present = presentIn(*drawn, graph);
                ASSERT_NEAR(costOf(space, present) + fixed, all, 1e-9) << "case " << number;
                const auto tracks =
                    (gaps ? graphOf({drawn->mesh, drawn->complex, drawn->graph}, present, free)
                          : tMeshOf({drawn->mesh, drawn->complex, drawn->graph}, present, free))
                        .tracks;
                ASSERT_EQ(static_cast<double>(corners.between(tracks, SubMeshId(0))), all)
                    << "case " << number;
            }
            ++compared;
        }
    EXPECT_GT(compared, cases / 2);
}

TEST(SearchProperty, ADiagramHoldsEveryGraphOnce) {
    int compared = 0;
    for (const bool gaps : {true, false})
        for (unsigned number = 0; number < cases; ++number) {
            auto drawn = drawCase(number);
            if (!drawn) continue;
            drawn->problem.gaps = gaps;
            const auto graphs = allGraphs(drawn->problem);
            if (!graphs) continue;
            const auto diagram = buildDiagram(drawn->problem, 1'000'000);
            ASSERT_TRUE(diagram);
            std::set<Assignment> walked;
            bool twice = false;
            const auto visit = [&](const Assignment& graph) {
                return twice = twice || !walked.insert(graph).second, true;
            };
            EXPECT_TRUE(walkDiagram(*diagram, infinity, visit));
            EXPECT_FALSE(twice) << "case " << number;
            EXPECT_EQ(walked, *graphs) << "case " << number;
            const auto paths = countPaths(*diagram);
            ASSERT_EQ(paths[diagram->root], BigCount(graphs->size())) << "case " << number;
            std::set<Assignment> ranked;
            for (BigCount rank = 0; rank < paths[diagram->root]; ++rank)
                ranked.insert(graphOfRank(*diagram, paths, rank));
            EXPECT_EQ(ranked, *graphs) << "case " << number;
            ++compared;
        }
    EXPECT_GT(compared, cases / 2);
}

/// States are told apart by what remains undecided; mistakes in this are rare, so many cases are tried.
TEST(SearchProperty, ADiagramCountsManyCases) {
    for (unsigned number = cases; number < 20 * cases; ++number) {
        const auto drawn = drawCase(number);
        if (!drawn) continue;
        const auto graphs = allGraphs(drawn->problem);
        if (!graphs) continue;
        const auto diagram = buildDiagram(drawn->problem, 1'000'000);
        ASSERT_TRUE(diagram);
        EXPECT_EQ(countPaths(*diagram)[diagram->root], BigCount(graphs->size())) << "case " << number;
    }
}

/// Pearson's statistic over all graphs of a case must be below its mean plus six standard deviations.
TEST(SearchProperty, DrawnGraphsAreUniform) {
    int tested = 0;
    for (unsigned number = 0; number < cases && tested < 5; ++number) {
        const auto drawn = drawCase(number);
        if (!drawn) continue;
        const auto graphs = allGraphs(drawn->problem);
        if (!graphs || graphs->size() < 20 || graphs->size() > 2000) continue;
        const auto diagram = buildDiagram(drawn->problem, 1'000'000);
        ASSERT_TRUE(diagram);
        const double expected = 40;
        std::map<Assignment, double> times;
        for (const Assignment& graph : drawGraphs(*diagram, 40 * graphs->size(), number))
            ++times[graph];
        EXPECT_LE(times.size(), graphs->size());
        double statistic = expected * static_cast<double>(graphs->size() - times.size());
        for (const auto& [graph, seen] : times) {
            EXPECT_TRUE(graphs->contains(graph));
            statistic += (seen - expected) * (seen - expected) / expected;
        }
        const auto freedom = static_cast<double>(graphs->size() - 1);
        EXPECT_LT(statistic, freedom + 6 * std::sqrt(2 * freedom)) << "case " << number;
        EXPECT_GT(statistic, freedom - 6 * std::sqrt(2 * freedom)) << "case " << number;
        ++tested;
    }
    EXPECT_EQ(tested, 5);
}

TEST(SearchProperty, TheOptimumAndTheBestAreThoseOfAllGraphs) {
    for (const double cornerCost : {0.0, 0.3, -0.2})
        for (const bool gaps : {true, false})
            for (unsigned number = 0; number < cases; ++number) {
                auto drawn = drawCase(number);
                if (!drawn) continue;
                drawn->problem.gaps = gaps;
                for (Crossing& crossing : drawn->problem.crossings)
                    crossing.cornerCost = cornerCost;
                const auto graphs = allGraphs(drawn->problem);
                if (!graphs || graphs->size() > 2000) continue;
                const std::vector<double> costs = sortedCosts(drawn->problem, *graphs);
                const OptimumResult one = findOptimum(drawn->problem, {});
                ASSERT_EQ(one.graphs.size(), costs.empty() ? 0U : 1U) << "case " << number;
                if (costs.empty()) continue;
                EXPECT_NEAR(costOf(drawn->problem, one.graphs[0]), costs[0], 1e-6) << "case " << number;
                EXPECT_NEAR(one.lowerBound, costs[0], 1e-6) << "case " << number;
                EXPECT_TRUE(one.complete);
                OptimumOptions options;
                options.nodesBeforeDiagram = 0;
                const OptimumResult fromDiagram = findOptimum(drawn->problem, options);
                ASSERT_EQ(fromDiagram.graphs.size(), 1U) << "case " << number;
                EXPECT_TRUE(graphs->contains(fromDiagram.graphs[0])) << "case " << number;
                EXPECT_NEAR(costOf(drawn->problem, fromDiagram.graphs[0]), costs[0], 1e-6);
                EXPECT_NEAR(fromDiagram.lowerBound, costs[0], 1e-6) << "case " << number;
                EXPECT_TRUE(fromDiagram.complete);
                options.best = 7;
                const OptimumResult several = findOptimum(drawn->problem, options);
                ASSERT_EQ(several.graphs.size(), std::min<std::size_t>(7, costs.size())) << "case " << number;
                for (std::size_t k = 0; k < several.graphs.size(); ++k) {
                    EXPECT_TRUE(graphs->contains(several.graphs[k]));
                    EXPECT_NEAR(costOf(drawn->problem, several.graphs[k]), costs[k], 1e-6)
                        << "case " << number;
                }
            }
}

/// The number of coordinate vectors, all of which the naive algorithm tries.
double vectorsOf(const Problem& problem) {
    double product = 1;
    for (const Course& course : findCourses(problem))
        product *= course.max + 1;
    return product;
}

TEST(SearchProperty, ThePapersAlgorithmsFindTheSameGraphs) {
    constexpr int many = 4 * cases; // a ring through a seed with two arcs is rare
    for (const auto method :
         {CoordinateMethod::naive, CoordinateMethod::bounds, CoordinateMethod::improved}) {
        int compared = 0;
        for (unsigned number = 0; number < many; ++number) {
            const auto drawn = drawCase(number);
            if (!drawn) continue;
            if (method == CoordinateMethod::naive && vectorsOf(drawn->problem) > 3e5) continue;
            std::set<Assignment> found;
            int visits = 0, questions = 0;
            const bool finished = forEachCoordinateVector(
                drawn->problem, method,
                [&](const Assignment& graph) {
                    found.insert(graph);
                    return ++visits < 30000;
                },
                [&] { return ++questions > 100; });
            if (!finished) continue;
            const auto graphs = allGraphs(drawn->problem);
            if (!graphs) continue;
            ++compared;
            EXPECT_EQ(found, *graphs) << "case " << number << " method " << static_cast<int>(method);
        }
        EXPECT_GT(compared, many / 4) << "method " << static_cast<int>(method);
    }
}

/// Random labels make the hardest cuts: particles leave and enter sub-meshes everywhere.
TEST(SearchProperty, MergingEndsInAValidGraphWhateverTheCut) {
    int cutMeshes = 0;
    for (unsigned number = 0; number < cases; ++number) {
        const auto drawn = drawCase(number);
        if (!drawn) continue;
        std::mt19937 random(number);
        SubMeshes parts{std::vector<SubMeshId>(drawn->mesh.n_vertices()), 1 + static_cast<int>(random() % 3)};
        for (SubMeshId& label : parts.labels)
            label = SubMeshId(random() % at(parts.count));
        const SearchedMesh searched{drawn->mesh, drawn->complex, drawn->angles, parts, {}};
        EnumerationOptions options;
        options.cost = {{0.9, 0.7}};
        const Enumeration found = enumerateGraphs(searched, options);
        const SearchSpace space = makeSearchSpace(drawn->mesh, drawn->complex, {drawn->costs}, parts, {});
        for (const std::size_t work : {std::size_t(0), GeneratorLimits().work}) {
            const GeneratorLimits limits{.complexity = 40, .rounds = MergeOptions().maxRounds, .work = work};
            const GeneratedGraph generated = generateGraph(searched, space, found, limits, {});
            EXPECT_TRUE(isMotorcycleGraph(space.graph, generated.present))
                << "case " << number << " work " << work;
        }
        const MergeResult merged = mergeGraphs(searched, found, 40, {});
        const auto present = presentArcs({drawn->mesh, drawn->complex, drawn->graph}, merged.graph.tracks);
        EXPECT_TRUE(isMotorcycleGraph(drawn->graph, present)) << "case " << number;
        EXPECT_NO_THROW((void)buildLayout(drawn->mesh, merged.graph.tracks, drawn->angles, drawn->costs))
            << "case " << number;
        EXPECT_NEAR(merged.graph.cost, costOf(drawn->problem, findOptimum(drawn->problem, {}).graphs.front()),
                    1e-6)
            << "case " << number << ": small enough to be searched as a whole";
        ++cutMeshes;
    }
    EXPECT_GT(cutMeshes, cases / 4);
}

TEST(SearchProperty, WindowsImproveAndLargeOnesReachTheOptimum) {
    std::size_t improvements = 0, fellShort = 0;
    for (unsigned number = 0; number < cases; ++number) {
        const auto drawn = drawCase(number);
        if (!drawn) continue;
        SearchState state(drawn->problem);
        if (!state.consistent()) continue;
        std::mt19937 random(number);
        const auto graphs = allGraphs(drawn->problem);
        if (!graphs || graphs->empty()) continue;
        const Assignment start =
            *std::next(graphs->begin(), static_cast<std::ptrdiff_t>(random() % graphs->size()));
        const double minCost = costOf(drawn->problem, findOptimum(drawn->problem, {}).graphs.front());
        const auto arcCosts = sumOverArcs(drawn->mesh, drawn->graph, drawn->complex, drawn->costs);
        const ProblemInput input{drawn->graph, arcCosts, {}, {}, {}, {}};
        const auto improve = [&](const WindowOptions& options, const Control& control) {
            WindowResult result = improveByWindows(input, presentIn(*drawn, start), options, control);
            improvements += result.improvements;
            return assignmentOf(drawn->problem, result.present);
        };
        const auto costs = [&](const Assignment& graph) { return costOf(drawn->problem, graph); };
        WindowOptions small;
        small.minVariables = small.maxVariables = 4;
        WindowOptions guided = small;
        for (std::size_t arc = 0; arc < drawn->graph.arcs.size(); ++arc)
            guided.relaxed.push_back(std::uniform_real_distribution<double>(0, 1)(random));
        WindowOptions agreeing = small;
        for (const bool present : presentIn(*drawn, start))
            agreeing.relaxed.push_back(present ? 1 : 0);
        EXPECT_EQ(improveByWindows(input, presentIn(*drawn, start), agreeing).windows, 0U)
            << "case " << number;
        for (const WindowOptions& options : {small, guided, WindowOptions{}}) {
            const Assignment better = improve(options, {});
            EXPECT_TRUE(graphs->contains(better)) << "case " << number;
            EXPECT_LE(costs(better), costs(start) + 1e-9);
            Control control;
            control.jobs = 3;
            EXPECT_EQ(improve(options, control), better);
            if (costs(better) > minCost + 1e-6) ++fellShort;
        }
        Control stopped;
        stopped.stopRequested = [] { return true; };
        EXPECT_EQ(improve({}, stopped), start);
        WindowOptions few;
        few.maxWindows = 0;
        EXPECT_EQ(improve(few, {}), start);
        WindowOptions all; // one window contains everything
        all.minVariables = drawn->problem.domains.size();
        all.nodes = 1; // too few for some windows, unless the search is patient
        all.patient = true;
        if (drawn->problem.chains.size() > 1 && independentParts(state).size() == 1) {
            EXPECT_NEAR(costs(improve(all, {})), minCost, 1e-6) << "case " << number;
        }
    }
    EXPECT_GT(improvements, 20U);
    EXPECT_GT(fellShort, 0U) << "small windows always reached the optimum: the cases are too easy";
}

/// Windows are searched eight at a time, so an earlier one may invalidate a later one.
TEST(SearchProperty, ManyWindowsTogetherLeaveAValidGraph) {
    std::size_t improvements = 0;
    for (unsigned seed = 0; seed < 30; ++seed) {
        const QuadMesh mesh = makeShape("random", {1, 0, seed, 80});
        const BaseComplex complex = buildBaseComplex(mesh);
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> cost(-1, 1);
        std::vector<double> costs(mesh.n_edges());
        std::ranges::generate(costs, [&] { return cost(random); });
        const SearchSpace space = makeSearchSpace(mesh, complex, {costs}, {}, {});
        const auto plain =
            presentArcs({mesh, complex, space.graph}, plainMotorcycleGraph(mesh, complex, costs).tracks);
        WindowOptions options;
        options.minVariables = options.maxVariables = 60;
        const ProblemInput input{space.graph, space.arcCosts, {}, {}, {}, {}};
        const WindowResult result = improveByWindows(input, plain, options);
        EXPECT_TRUE(isMotorcycleGraph(space.graph, result.present)) << "seed " << seed;
        improvements += result.improvements;
    }
    EXPECT_GT(improvements, 200U);
}

TEST(SearchProperty, ImprovedGraphsAreProvenAndNeverDearer) {
    std::size_t cheaper = 0;
    for (unsigned number = 0; number < cases; ++number) {
        const auto drawn = drawCase(number);
        if (!drawn || drawn->graph.arcs.empty()) continue;
        const MotorcycleGraph plain = plainMotorcycleGraph(drawn->mesh, drawn->complex, drawn->costs);
        const double minCost = costOf(drawn->problem, findOptimum(drawn->problem, {}).graphs.front());
        const SearchSpace space = makeSearchSpace(drawn->mesh, drawn->complex, {drawn->costs}, {}, {});
        const PresentArcs before = presentArcs({drawn->mesh, drawn->complex, space.graph}, plain.tracks);
        const Improvement better = improveGraph(space, before, 1e9);
        EXPECT_TRUE(isMotorcycleGraph(space.graph, better.present)) << "case " << number;
        const double cost = costOf(space, better.present);
        EXPECT_NEAR(cost, minCost, 1e-6) << "case " << number;
        EXPECT_NEAR(better.lowerBound, minCost, 1e-6) << "case " << number;
        if (cost < plain.cost - 1e-6) ++cheaper;
        const Improvement hurried = improveGraph(space, before, 1e-9);
        EXPECT_LE(costOf(space, hurried.present), plain.cost + 1e-9);
        EXPECT_LE(hurried.lowerBound, minCost + 1e-6);
    }
    EXPECT_GT(cheaper, 10U);
}

TEST(SearchProperty, ThreadsChangeNothing) {
    std::optional<Case> drawn;
    for (unsigned number = 0; !drawn || drawn->graph.arcs.size() < 20; ++number)
        drawn = drawCase(number);
    SubMeshes parts{std::vector<SubMeshId>(drawn->mesh.n_vertices()), 3};
    for (std::size_t v = 0; v < parts.labels.size(); ++v)
        parts.labels[v] = SubMeshId(v % 3);
    const SearchedMesh searched{drawn->mesh, drawn->complex, drawn->angles, parts, {}};
    std::vector<std::vector<HalfedgeId>> first;
    for (const unsigned jobs : {1U, 2U, 5U}) {
        Control control;
        control.jobs = jobs;
        const Enumeration found = enumerateGraphs(searched, {}, control);
        const MergeResult merged = mergeGraphs(searched, found, 40, {}, control);
        std::vector<std::vector<HalfedgeId>> tracks;
        for (const Track& track : merged.graph.tracks)
            tracks.push_back(track.halfedges);
        if (first.empty()) first = tracks;
        EXPECT_EQ(tracks, first);
    }
}

} // namespace
} // namespace qm::test
