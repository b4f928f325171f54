#include "support/mesh_text.h"

#include "base/infinity.h"
#include "mesh/quad_geometry.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>

namespace qm::test {

std::vector<Point> pointsOf(const QuadMesh& mesh) {
    std::vector<Point> points;
    for (const VertexId vertex : mesh.vertices())
        points.push_back(mesh.point(vertex));
    return points;
}

std::vector<FaceIndices> facesOf(const QuadMesh& mesh) {
    std::vector<FaceIndices> faces;
    for (const FaceId face : mesh.faces())
        std::ranges::transform(cornersOf(mesh, face), faces.emplace_back().begin(),
                               [](VertexId vertex) { return vertex.idx(); });
    return faces;
}

double largestDistance(const QuadMesh& a, const QuadMesh& b) {
    if (a.n_vertices() != b.n_vertices()) return infinity;
    double largest = 0;
    for (const VertexId vertex : a.vertices())
        largest = std::max(largest, (a.point(vertex) - b.point(vertex)).norm());
    return largest;
}

namespace {

void expectConsistentHalfedges(const QuadMesh& mesh) {
    for (const HalfedgeId halfedge : mesh.halfedges()) {
        const HalfedgeId next = mesh.next_halfedge_handle(halfedge);
        ASSERT_TRUE(mesh.is_valid_handle(next));
        ASSERT_EQ(mesh.from_vertex_handle(next), mesh.to_vertex_handle(halfedge));
        ASSERT_EQ(mesh.face_handle(next), mesh.face_handle(halfedge));
        ASSERT_EQ(mesh.prev_halfedge_handle(next), halfedge);
        ASSERT_NE(next, mesh.opposite_halfedge_handle(halfedge));
        ASSERT_FALSE(mesh.is_boundary(halfedge) && mesh.is_boundary(mesh.opposite_halfedge_handle(halfedge)));
    }
}

} // namespace

void expectConsistent(const QuadMesh& mesh) {
    expectConsistentHalfedges(mesh);
    if (::testing::Test::HasFatalFailure()) return;
    for (const FaceId face : mesh.faces()) {
        ASSERT_EQ(mesh.valence(face), 4U);
        auto corners = cornersOf(mesh, face);
        std::sort(corners.begin(), corners.end());
        ASSERT_EQ(std::adjacent_find(corners.begin(), corners.end()), corners.end());
    }
    std::size_t leaving = 0;
    for (const VertexId vertex : mesh.vertices()) {
        bool meetsBoundary = false;
        for (const HalfedgeId halfedge : mesh.voh_range(vertex)) {
            ASSERT_EQ(mesh.from_vertex_handle(halfedge), vertex);
            meetsBoundary = meetsBoundary || mesh.is_boundary(mesh.edge_handle(halfedge));
            ++leaving;
        }
        ASSERT_EQ(mesh.is_boundary(vertex), meetsBoundary || mesh.is_isolated(vertex));
    }
    ASSERT_EQ(leaving, mesh.n_halfedges()) << "a vertex has several fans";
}

template <class Number> void BinaryText::putAs(double value) {
    auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(static_cast<Number>(value));
    if (littleEndian_ != (std::endian::native == std::endian::little)) std::ranges::reverse(raw);
    bytes.append(raw.data(), raw.size());
}

void BinaryText::put(const std::string& type, double value) {
    if (type == "char" || type == "int8") putAs<std::int8_t>(value);
    if (type == "uchar" || type == "uint8") putAs<std::uint8_t>(value);
    if (type == "short" || type == "int16") putAs<std::int16_t>(value);
    if (type == "ushort" || type == "uint16") putAs<std::uint16_t>(value);
    if (type == "int" || type == "int32") putAs<std::int32_t>(value);
    if (type == "uint" || type == "uint32") putAs<std::uint32_t>(value);
    if (type == "float" || type == "float32") putAs<float>(value);
    if (type == "double" || type == "float64") putAs<double>(value);
}

} // namespace qm::test
