#include "base/at.h"
#include "base/infinity.h"
#include "cut/energy.h"
#include "cut/surface_distances.h"
#include "mesh/soup/build_mesh.h"
#include "support/track_along.h"
#include "support/vertices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace qm::test {
namespace {

CutProblem problemOf(const QuadMesh& mesh, const std::vector<VertexId>& extraordinary,
                     const TerminalPair& terminals, const CutOptions& options,
                     const std::vector<double>& angles) {
    const std::vector<SubMeshId> labels(mesh.n_vertices(), SubMeshId(0));
    SurfaceDistances geodesics(mesh, labels);
    geodesics.prepare(verticesOf(mesh));
    return Energy(mesh, angles, options, labels)(verticesOf(mesh), extraordinary, terminals, geodesics);
}

CutProblem problemOf(const QuadMesh& mesh, const std::vector<VertexId>& extraordinary,
                     const TerminalPair& terminals, const CutOptions& options = {}) {
    return problemOf(mesh, extraordinary, terminals, options, std::vector<double>(mesh.n_edges(), 0));
}

/// E(L) as stated in docs/METHOD.md#mesh-cut, in a plane, where distances are straight; with nullopt, D
/// follows from the distances.
double statedEnergy(const QuadMesh& mesh, VertexId source, VertexId sink,
                    const std::map<VertexId, int>& groups, const CutOptions& o,
                    const std::vector<int>& labels) {
    double energy = 0;
    for (const VertexId p : mesh.vertices()) {
        const int label = labels[at(p)];
        const double toSource = (mesh.point(p) - mesh.point(source)).norm();
        const double toSink = (mesh.point(p) - mesh.point(sink)).norm();
        double d = 1 - (label == 0 ? toSource : toSink) / (toSource + toSink);
        if (groups.contains(p)) d = groups.at(p) == label ? 1 : 0;
        const double nu = (o.highPenalty - o.lowPenalty) / (o.farLimit - o.nearLimit);
        if (d <= o.nearLimit)
            energy += o.highPenalty;
        else if (d <= o.farLimit)
            energy += o.lowPenalty + nu * (o.farLimit - d);
        else
            energy += o.lowPenalty;
    }
    for (const EdgeId edge : mesh.edges()) {
        const HalfedgeId h = mesh.halfedge_handle(edge, 0);
        if (labels[at(mesh.from_vertex_handle(h))] != labels[at(mesh.to_vertex_handle(h))])
            energy += o.lambda;
    }
    return energy;
}

TEST(CutEnergy, IsThatOfTheMethodAndItsCutTheBestOfAllLabellings) {
    const QuadMesh mesh = rectangle(3, 2); // 12 vertices, 4096 labellings
    for (const auto& [source, sink] : {std::pair(0, 11), std::pair(4, 7), std::pair(1, 6)})
        for (const double lambda : {0.0, 1.0, 7.0, 30.0})
            for (const bool grouped : {false, true}) {
                CutOptions options;
                options.lambda = lambda;
                TerminalPair terminals{VertexId(source), VertexId(sink), {}};
                std::map<VertexId, int> groups;
                if (grouped) {
                    terminals.groups = {{{VertexId(2), VertexId(5)}, {VertexId(9)}}};
                    groups = {{VertexId(2), 0}, {VertexId(5), 0}, {VertexId(9), 1}};
                }
                const CutProblem problem = problemOf(mesh, {}, terminals, options);
                const auto energy = [&](const std::vector<int>& labels) {
                    return statedEnergy(mesh, terminals.source, terminals.sink, groups, options, labels);
                };
                double min = infinity;
                for (unsigned bits = 0; bits < 4096; ++bits) {
                    std::vector<int> labels(12);
                    for (std::size_t k = 0; k < 12; ++k)
                        labels[k] = static_cast<int>(bits >> k & 1U);
                    min = std::min(min, energy(labels));
                }
                EXPECT_NEAR(energy(minimumCut(problem)), min, 1e-6);
            }
}

TEST(CutEnergy, SendsExtraordinaryVerticesToTheNearerTerminalIfThereAreNoGroups) {
    const QuadMesh mesh = rectangle(6, 1);
    const CutProblem problem = problemOf(mesh, {VertexId(2), VertexId(4)}, {VertexId(0), VertexId(6), {}});
    EXPECT_EQ(problem.costs[2], (std::array<double, 2>{1, 80}));
    EXPECT_EQ(problem.costs[4], (std::array<double, 2>{80, 1}));
    // In the middle, at D = 0.5, both sides cost the same; one step beside it they do not.
    EXPECT_EQ(problem.costs[3], (std::array<double, 2>{1, 1}));
    EXPECT_EQ(problem.costs[0], (std::array<double, 2>{1, 80}));
}

TEST(CutEnergy, HoldsOnlyForTheSubMesh) {
    const QuadMesh mesh = rectangle(4, 2);
    std::vector<SubMeshId> labels(15, SubMeshId(3));
    const std::vector<VertexId> inside{VertexId(0), VertexId(1), VertexId(5), VertexId(6)};
    for (const VertexId vertex : inside)
        labels[at(vertex)] = SubMeshId(8);
    SurfaceDistances geodesics(mesh, labels);
    geodesics.prepare(inside);
    const std::vector<double> flat(mesh.n_edges(), 0);
    Energy energy(mesh, flat, {}, labels);
    const CutProblem problem = energy(inside, {}, {VertexId(0), VertexId(6), {}}, geodesics);
    EXPECT_EQ(problem.costs.size(), 4U);
    EXPECT_EQ(problem.edges.size(), 4U);
    for (const CutProblem::Edge& edge : problem.edges)
        EXPECT_TRUE(edge.a >= 0 && edge.a < 4 && edge.b >= 0 && edge.b < 4);
}

TEST(CutEnergy, WeighsEdgesBesideFeaturesIfAsked) {
    const QuadMesh mesh = rectangle(4, 4);
    const PerEdge angles = PerEdge(mesh, 0).along({10, 11, 12, 13, 14}, std::numbers::pi / 2);
    const TerminalPair terminals{VertexId(0), VertexId(24), {}};
    CutOptions options;
    for (const CutProblem::Edge& edge : problemOf(mesh, {}, terminals, options, angles).edges)
        EXPECT_EQ(edge.capacity, 1);
    options.avoidFeatures = true;
    for (const CutProblem::Edge& edge : problemOf(mesh, {}, terminals, options, angles).edges) {
        const bool touches = edge.a / 5 == 2 || edge.b / 5 == 2;
        EXPECT_DOUBLE_EQ(edge.capacity, touches ? 81 : 1) << edge.a << ' ' << edge.b;
    }
}

TEST(CutEnergy, IsFiniteOnMeshesWithoutSizeAndWithWeightsWithoutBound) {
    for (const double size : {0.0, 1.0, 1e140}) {
        const QuadMesh mesh = buildMesh({{0, 0, 0}, {size, 0, 0}, {size, size, 0}, {0, size, 0}},
                                        {std::array<int, 4>{0, 1, 2, 3}});
        for (const double weight : {0.0, 1e300, infinity}) {
            CutOptions options;
            options.lambda = weight;
            options.highPenalty = weight;
            options.avoidFeatures = true;
            options.nearLimit = options.farLimit = 0.5;
            const CutProblem problem =
                problemOf(mesh, {VertexId(0)}, {VertexId(0), VertexId(2), {}}, options);
            for (const auto& cost : problem.costs)
                EXPECT_TRUE(std::isfinite(cost[0]) && std::isfinite(cost[1]));
            for (const CutProblem::Edge& edge : problem.edges)
                EXPECT_TRUE(std::isfinite(edge.capacity));
            EXPECT_EQ(minimumCut(problem).size(), 4U);
        }
    }
}

} // namespace
} // namespace qm::test
