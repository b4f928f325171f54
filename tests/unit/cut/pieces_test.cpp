// The sub-meshes of a cut in the making.
#include "base/at.h"
#include "cut/label_components.h"
#include "cut/pieces.h"
#include "support/polycube.h"
#include "support/random_graph.h"
#include "support/vertices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace qm::test {
namespace {

TEST(PieceDivision, BeginsWithTheWholeMesh) {
    const QuadMesh mesh = quadMesh(polycube(bump(), 2));
    const BaseComplex complex = buildBaseComplex(mesh);
    PieceDivision division(mesh, complex);
    const Piece whole = division.whole();
    EXPECT_EQ(whole.vertices.size(), mesh.n_vertices());
    EXPECT_EQ(whole.separatrices.size(), complex.separatrices.size());
    EXPECT_EQ(division.sourcesOf(whole).extraordinary, complex.extraordinaryVertices);
    EXPECT_TRUE(division.sourcesOf(whole).seeds.empty());
    const std::vector<SubMeshId> labels(mesh.n_vertices(), SubMeshId(0));
    const auto measured = measureSubMeshes(mesh, complex, labels, 1);
    EXPECT_EQ(whole.measures.quasiComplexity, measured[SubMeshId(0)].quasiComplexity);
}

TEST(PieceDivision, GivesPartsTheirVerticesParticlesAndMeasures) {
    const QuadMesh mesh = quadMesh(polycube(bump(), 2));
    std::mt19937 random(1);
    const BaseComplex complex = buildBaseComplex(mesh, randomSeeds(mesh, 4, random));
    PieceDivision division(mesh, complex);
    Piece whole = division.whole();
    whole.measures.source = VertexId(3);
    std::vector<int> partOf;
    for (std::size_t k = 0; k < whole.vertices.size(); ++k)
        partOf.push_back(static_cast<int>(random() % 3));
    division.label(whole);
    const std::vector<Piece> parts = division.divide(whole, partOf, 3);
    ASSERT_EQ(parts.size(), 3U);
    std::size_t vertices = 0, separatrices = 0;
    std::vector<SubMeshId> labels(mesh.n_vertices());
    for (std::size_t part = 0; part < 3; ++part) {
        EXPECT_TRUE(
            std::ranges::is_sorted(parts[part].vertices, {}, [](VertexId vertex) { return vertex.idx(); }));
        EXPECT_EQ(parts[part].measures.source, VertexId(3));
        for (const VertexId vertex : parts[part].vertices) {
            EXPECT_EQ(partOf[at(vertex)], static_cast<int>(part));
            EXPECT_EQ(division.labels()[at(vertex)], SubMeshId(part));
            labels[at(vertex)] = SubMeshId(part);
        }
        for (const SeparatrixId separatrix : parts[part].separatrices)
            EXPECT_EQ(partOf[at(division.sourceOf(separatrix))], static_cast<int>(part));
        vertices += parts[part].vertices.size();
        separatrices += parts[part].separatrices.size();
    }
    EXPECT_EQ(vertices, whole.vertices.size());
    EXPECT_EQ(separatrices, whole.separatrices.size());
    const auto measured = measureSubMeshes(mesh, complex, labels, 3);
    for (std::size_t part = 0; part < 3; ++part) {
        EXPECT_NEAR(parts[part].measures.quasiComplexity, measured[SubMeshId(part)].quasiComplexity, 1e-9);
        EXPECT_EQ(parts[part].measures.ordinaryJunctions, measured[SubMeshId(part)].ordinaryJunctions);
    }
    division.label(whole);
    EXPECT_EQ(division.labels(), std::vector(mesh.n_vertices(), division.labels().front()));
    EXPECT_TRUE(division.labels().front().valid());
    division.unlabel(whole);
    EXPECT_EQ(division.labels(), std::vector<SubMeshId>(mesh.n_vertices()));
}

TEST(LabelComponents, AreNumberedByTheirLowestVertices) {
    // Two cubes of eight vertices and a torus of nine; the torus is another sub-mesh in part.
    const QuadMesh mesh = quadMesh(together({polycube(box(1, 1, 1)), torus(3, 3), polycube(box(1, 1, 1))}));
    std::vector<SubMeshId> labels(mesh.n_vertices(), SubMeshId(0));
    for (const int row : {0, 2}) // of three: what is left is not connected to them
        for (int column = 0; column < 3; ++column)
            labels[at(8 + 3 * row + column)] = SubMeshId(1);
    LabelComponents components(mesh, labels);
    std::vector<VertexId> first, second;
    for (const VertexId vertex : mesh.vertices())
        (labels[at(vertex)] == SubMeshId(0) ? first : second).push_back(vertex);
    EXPECT_EQ(components.number(first), 3);
    EXPECT_EQ(components.componentOf(VertexId(0)), 0);
    EXPECT_EQ(components.componentOf(VertexId(7)), 0);
    EXPECT_EQ(components.componentOf(VertexId(11)), 1);
    EXPECT_EQ(components.componentOf(VertexId(24)), 2);
    EXPECT_EQ(components.number(second), 1) << "rows 0 and 2 of a torus are neighbours";
    labels.assign(labels.size(), SubMeshId(0));
    EXPECT_EQ(components.number(verticesOf(mesh)), 3);
}

} // namespace
} // namespace qm::test
