#include "mesh/nesting.h"
#include "shape/shape.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace qm {
namespace {

/// A sample mesh, scaled about the origin and then moved.
ClosedMesh closed(const char* name, double scale, const Point& to = {0, 0, 0}, bool inwards = false) {
    const QuadMesh mesh = makeShape(name);
    ClosedMesh triangles;
    for (const FaceId face : mesh.faces())
        addQuad(mesh, face, triangles);
    for (auto& triangle : triangles) {
        for (Point& corner : triangle)
            corner = scale * corner + to;
        if (inwards) std::swap(triangle[0], triangle[1]);
    }
    return triangles;
}

ClosedMesh sphere(double radius, bool inwards = false) {
    return closed("sphere", radius, {0, 0, 0}, inwards);
}

std::vector<std::optional<std::size_t>> cavities(const std::vector<ClosedMesh>& meshes) {
    std::vector<std::optional<std::size_t>> result;
    for (const Nesting& nesting : nestingOf(meshes))
        result.push_back(nesting.cavityOf);
    return result;
}

using Of = std::vector<std::optional<std::size_t>>;

TEST(Nesting, CavitiesAreInsideAndLookTheOtherWay) {
    EXPECT_EQ(cavities({sphere(2), sphere(1, true)}), (Of{{}, 0}));
    EXPECT_EQ(cavities({sphere(1, true), sphere(2)}), (Of{1, {}})) << "in any order";
    EXPECT_EQ(cavities({sphere(2), sphere(1)}), (Of{{}, {}})) << "two solids";
    EXPECT_EQ(cavities({sphere(2), closed("sphere", 1, {5, 0, 0}, true)}), (Of{{}, {}})) << "beside";
    EXPECT_EQ(cavities({sphere(1), {}, closed("cube", 0.2, {-0.1, 0.3, 0.2}, true)}), (Of{{}, {}, 0}));
}

TEST(Nesting, WhatLiesInACavityIsASolid) {
    EXPECT_EQ(cavities({sphere(4), sphere(3, true), sphere(2), sphere(1, true)}), (Of{{}, 0, {}, 2}));
    const std::vector<Nesting> turned = nestingOf({sphere(4), sphere(3, true), sphere(2, true)});
    EXPECT_FALSE(turned[2].cavityOf);
    EXPECT_TRUE(turned[2].inward);
}

TEST(Nesting, AMeshThatIsInsideOutIsTurnedWithItsCavities) {
    const std::vector<Nesting> nesting = nestingOf({sphere(2, true), sphere(1)});
    EXPECT_TRUE(nesting[0].inward);
    EXPECT_EQ(nesting[1].cavityOf, 0U);
    EXPECT_TRUE(nesting[1].inward);
}

TEST(Nesting, TheHoleOfARingIsNotInside) {
    EXPECT_EQ(cavities({closed("torus", 1), closed("sphere", 0.3, {0, 0, 0}, true)}), (Of{{}, {}}));
    const ClosedMesh inTube = closed("sphere", 0.3, {3, 0, 0}, true); // from the axis to the tube
    EXPECT_EQ(cavities({closed("torus", 1), inTube}), (Of{{}, 0}));
}

TEST(Nesting, ManyCavitiesAreFoundAtOnce) {
    std::vector<ClosedMesh> meshes{closed("cube", 20, {-10, -10, -10})};
    for (int i = 0; i < 10; ++i)
        for (int j = 0; j < 20; ++j)
            meshes.push_back(closed("sphere", 0.3, Point(i - 4.5, 0.9 * j - 9, 0.1), true));
    std::size_t found = 0;
    for (const auto& of : cavities(meshes))
        if (of == 0) ++found;
    EXPECT_EQ(found, 200U);
}

} // namespace
} // namespace qm
