#include "base/at.h"
#include "cut/farthest_pair.h"
#include "cut/surface_distances.h"
#include "mesh/soup/build_mesh.h"
#include "mesh/topology.h"
#include "support/random_graph.h"
#include "support/track_along.h"
#include "support/vertices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace qm::test {
namespace {

/// The largest distance, found by sweeping from every vertex.
double longestOfAll(const std::vector<VertexId>& vertices, SurfaceDistances& geodesics) {
    double longest = 0;
    for (const VertexId from : vertices)
        longest = std::max(longest, std::ranges::max(geodesics.between(from, vertices)));
    return longest;
}

std::vector<VertexId> someVertices(const QuadMesh& mesh, std::size_t count, std::mt19937& random) {
    const std::vector<VertexId> all = verticesOf(mesh);
    std::vector<VertexId> some;
    std::ranges::sample(all, std::back_inserter(some), static_cast<std::ptrdiff_t>(count), random);
    return some;
}

void expectConsistent(const FarthestPair& pair, const std::vector<VertexId>& vertices,
                      SurfaceDistances& geodesics) {
    ASSERT_LT(pair.first, pair.second);
    ASSERT_LT(pair.second, vertices.size());
    EXPECT_EQ(pair.fromFirst, geodesics.between(vertices[pair.first], vertices));
    EXPECT_EQ(pair.fromSecond, geodesics.between(vertices[pair.second], vertices));
}

TEST(FarthestPair, IsThatOfAllPairsInThePlane) {
    std::mt19937 random(3);
    const QuadMesh mesh = rectangle(30, 20);
    const std::vector<SubMeshId> whole(mesh.n_vertices(), SubMeshId(0));
    SurfaceDistances geodesics(mesh, whole);
    geodesics.prepare(verticesOf(mesh));
    for (const std::size_t count : {2U, 3U, 5U, 20U, 60U}) {
        const std::vector<VertexId> vertices = someVertices(mesh, count, random);
        const FarthestPair pair = farthestPair(vertices, geodesics);
        expectConsistent(pair, vertices, geodesics);
        EXPECT_NEAR(pair.fromFirst[pair.second], longestOfAll(vertices, geodesics), 1e-5) << count;
    }
}

TEST(FarthestPair, IsNearlyThatOfAllPairsOnAnySurface) {
    std::mt19937 random(4);
    for (int round = 0; round < 60; ++round) {
        const std::optional<QuadMesh> mesh = randomMesh(random);
        if (!mesh || mesh->n_vertices() < 8) continue;
        // The result may be shorter only by what distances there and back differ on such coarse meshes.
        const std::vector<int> component = components(*mesh).ofVertex;
        const std::vector<SubMeshId> part(component.begin(), component.end());
        SurfaceDistances geodesics(*mesh, part);
        std::vector<VertexId> vertices;
        for (const VertexId vertex : mesh->vertices())
            if (component[at(vertex)] == 0) vertices.push_back(vertex);
        if (vertices.size() < 2) continue;
        geodesics.prepare(vertices);
        const FarthestPair pair = farthestPair(vertices, geodesics);
        EXPECT_GE(std::max(pair.fromFirst[pair.second], pair.fromSecond[pair.first]),
                  0.9 * longestOfAll(vertices, geodesics));
    }
}

TEST(FarthestPair, CopesWithMoreVerticesThanPairsAreKeptFor) {
    const QuadMesh mesh = rectangle(60, 50);
    const std::vector<SubMeshId> whole(mesh.n_vertices(), SubMeshId(0));
    const std::vector<VertexId> all = verticesOf(mesh);
    SurfaceDistances geodesics(mesh, whole);
    geodesics.prepare(all);
    ASSERT_GT(all.size(), 2048U);
    const FarthestPair pair = farthestPair(all, geodesics);
    EXPECT_NEAR(pair.fromFirst[pair.second], std::hypot(60, 50), 1e-3);
}

TEST(FarthestPair, OfPointsInOnePlaceIsSome) {
    const QuadMesh mesh =
        buildMesh({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {std::array<int, 4>{0, 1, 2, 3}});
    const std::vector<SubMeshId> whole(4, SubMeshId(0));
    SurfaceDistances geodesics(mesh, whole);
    geodesics.prepare(verticesOf(mesh));
    const FarthestPair pair = farthestPair({VertexId(0), VertexId(2), VertexId(3)}, geodesics);
    EXPECT_EQ(pair.fromFirst[pair.second], 0);
    EXPECT_NE(pair.first, pair.second);
}

} // namespace
} // namespace qm::test
