#include "base/at.h"
#include "mesh/boundary_loops.h"
#include "mesh/files/write_soup.h"
#include "mesh/soup/build_mesh.h"
#include "remesh/close_holes.h"
#include "shape/shape.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace qm {
namespace {

using Quads = std::vector<std::array<int, 4>>;

std::vector<Point> pointsOf(const QuadMesh& mesh) {
    return soupOf(mesh).points;
}

Quads quadsOf(const QuadMesh& mesh) {
    const Soup soup = soupOf(mesh);
    Quads quads(soup.faceCount());
    for (std::size_t k = 0; k < quads.size(); ++k)
        std::ranges::copy(soup.face(k), quads[k].begin());
    return quads;
}

QuadMesh withoutFaces(const QuadMesh& mesh, const std::set<int>& missing) {
    Quads quads;
    for (int k = 0; const auto& quad : quadsOf(mesh))
        if (!missing.contains(k++)) quads.push_back(quad);
    return buildMesh(pointsOf(mesh), quads);
}

/// Contracts edges, and leaves out the faces that then are no quads.
QuadMesh contracted(const QuadMesh& mesh, const std::vector<EdgeId>& edges) {
    std::map<int, int> target;
    for (const EdgeId edge : edges) {
        const HalfedgeId halfedge = mesh.halfedge_handle(edge, 0);
        target[mesh.to_vertex_handle(halfedge).idx()] = mesh.from_vertex_handle(halfedge).idx();
    }
    Quads quads;
    for (auto quad : quadsOf(mesh)) {
        for (int& corner : quad)
            if (const auto found = target.find(corner); found != target.end()) corner = found->second;
        if (std::set<int>(quad.begin(), quad.end()).size() == 4) quads.push_back(quad);
    }
    return buildMesh(pointsOf(mesh), quads);
}

/// Edges one after the other, each opposite to the one before it in the quad between them.
std::vector<EdgeId> rowOfEdges(const QuadMesh& mesh, FaceId begin, int count) {
    std::vector<EdgeId> edges;
    HalfedgeId entry = mesh.opposite_halfedge_handle(mesh.halfedge_handle(begin));
    for (int k = 0; k < count; ++k) {
        edges.push_back(mesh.edge_handle(entry));
        entry = mesh.opposite_halfedge_handle(mesh.next_halfedge_handle(mesh.next_halfedge_handle(entry)));
    }
    return edges;
}

int characteristic(const QuadMesh& mesh) {
    return static_cast<int>(mesh.n_vertices()) - static_cast<int>(mesh.n_edges()) +
           static_cast<int>(mesh.n_faces());
}

TEST(CloseHoles, LeavesAClosedMeshAsItIs) {
    const QuadMesh cube = makeShape("cube");
    EXPECT_EQ(quadsOf(closeHoles(cube, {})), quadsOf(cube));
}

TEST(CloseHoles, FillsHolesOfAnEvenNumberOfEdges) {
    const QuadMesh cube = makeShape("cube");
    const HalfedgeId halfedge = cube.halfedge_handle(FaceId(9));
    const FaceId beside = cube.face_handle(cube.opposite_halfedge_handle(halfedge));
    const QuadMesh holed = withoutFaces(cube, {9, beside.idx(), 40});
    ASSERT_EQ(boundaryLoops(holed).size(), 2U);
    const QuadMesh closed = closeHoles(holed, {});
    EXPECT_TRUE(boundaryLoops(closed).empty());
    EXPECT_EQ(closed.n_faces(), cube.n_faces());
    EXPECT_EQ(closed.n_edges(), cube.n_edges());
}

TEST(CloseHoles, JoinsTrianglesByARow) {
    const QuadMesh cube = makeShape("cube");
    for (int length = 2; length <= 6; ++length) {
        const std::vector<EdgeId> edges = rowOfEdges(cube, FaceId(0), length);
        const QuadMesh holed = contracted(cube, edges);
        const std::vector<BoundaryLoop> loops = boundaryLoops(holed);
        ASSERT_EQ(loops.size(), 2U);
        ASSERT_EQ(loops[0].edges, 3U);
        ASSERT_EQ(loops[1].edges, 3U);
        const QuadMesh closed = closeHoles(holed, {});
        EXPECT_TRUE(boundaryLoops(closed).empty());
        EXPECT_EQ(characteristic(closed), 2 + length) << "with the vertices that are isolated now";
    }
}

TEST(CloseHoles, RowsTurnWhereTheyMust) {
    const QuadMesh cube = makeShape("cube");
    for (unsigned round = 0; round < 40; ++round) {
        std::set<int> near; // vertices of faces at contracted edges: these faces must be apart
        std::vector<EdgeId> edges;
        for (unsigned k = 0; k < 3; ++k) {
            const FaceId begin(static_cast<int>((round * 37 + k * 61) % cube.n_faces()));
            const std::vector<EdgeId> row = rowOfEdges(cube, begin, 2 + static_cast<int>(round + k) % 3);
            std::set<int> around;
            for (const EdgeId edge : row)
                for (unsigned side = 0; side < 2; ++side)
                    for (const VertexId vertex :
                         cube.fv_range(cube.face_handle(cube.halfedge_handle(edge, side))))
                        around.insert(vertex.idx());
            if (std::ranges::any_of(around, [&](int vertex) { return near.contains(vertex); })) continue;
            near.merge(around);
            edges.insert(edges.end(), row.begin(), row.end());
        }
        QuadMesh holed = contracted(cube, edges);
        ASSERT_GE(boundaryLoops(holed).size(), 2U);
        EXPECT_TRUE(boundaryLoops(closeHoles(holed, {})).empty()) << "round " << round;
    }
}

TEST(CloseHoles, LeavesLargeHoles) {
    const QuadMesh plate = makeShape("plate");
    const QuadMesh closed = closeHoles(plate, {});
    EXPECT_EQ(boundaryLoops(closed).size(), boundaryLoops(plate).size());
    EXPECT_EQ(closed.n_faces(), plate.n_faces());
}

TEST(CloseHoles, LeavesHolesOfTheScan) {
    const QuadMesh plate = makeShape("plate");
    FaceId inside;
    for (const FaceId face : plate.faces())
        if (std::ranges::none_of(plate.fv_range(face), [&](VertexId v) { return plate.is_boundary(v); }))
            inside = face;
    ASSERT_TRUE(inside.is_valid());
    const QuadMesh holed = withoutFaces(plate, {inside.idx()});
    const auto trianglesOf = [](const QuadMesh& mesh) {
        Triangles scan;
        for (const VertexId vertex : mesh.vertices())
            scan.points.push_back(mesh.point(vertex));
        for (const FaceId face : mesh.faces()) {
            std::vector<int> corners;
            for (const VertexId vertex : mesh.fv_range(face))
                corners.push_back(vertex.idx());
            scan.faces.push_back({corners[0], corners[1], corners[2]});
            scan.faces.push_back({corners[0], corners[2], corners[3]});
        }
        return scan;
    };
    EXPECT_EQ(closeHoles(holed, trianglesOf(plate)).n_faces(), plate.n_faces());
    EXPECT_EQ(closeHoles(holed, trianglesOf(holed)).n_faces(), holed.n_faces());
}

} // namespace
} // namespace qm
