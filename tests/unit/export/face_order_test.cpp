#include "export/boundary/face_order.h"

#include <gtest/gtest.h>

#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <algorithm>
#include <numeric>

namespace qm {
namespace {

using Faces = std::vector<std::size_t>;

Handle(Geom_Surface) aPlane() {
    return new Geom_Plane(gp::XOY());
}
Handle(Geom_Surface) aCylinder() {
    return new Geom_CylindricalSurface(gp_Ax3(gp::XOY()), 1);
}

/// Faces side by side between two vertices, like slices of half an apple: faces 0, 1, 2 ... of `numbers`,
/// with smooth edges between them, in one part, in the order of their numbers.
Boundary slices(const Faces& numbers) {
    Boundary boundary;
    boundary.vertices.resize(2);
    boundary.edges.resize(numbers.size() + 1);
    for (std::size_t e = 0; e <= numbers.size(); ++e) {
        boundary.edges[e].ends = {0, 1};
        boundary.edges[e].isSmooth = e > 0 && e < numbers.size();
    }
    boundary.faces.resize(numbers.size());
    for (std::size_t k = 0; k < numbers.size(); ++k)
        boundary.faces[numbers[k]] = {aPlane(), false, true, {{{k, true}, {k + 1, false}}}};
    boundary.parts.resize(1);
    for (std::size_t f = 0; f < numbers.size(); ++f)
        boundary.parts[0].faces.push_back(f);
    return boundary;
}

/// Whether the faces placed so far are side by side at any time.
bool growsTogether(const Faces& order, const Faces& fan) {
    std::size_t first = fan.size();
    std::size_t last = 0;
    std::size_t count = 0;
    for (const std::size_t face : order) {
        const auto place = std::ranges::find(fan, face);
        if (place == fan.end()) continue;
        first = std::min(first, static_cast<std::size_t>(place - fan.begin()));
        last = std::max(last, static_cast<std::size_t>(place - fan.begin()));
        if (last - first != count++) return false;
    }
    return count == fan.size();
}

TEST(FaceOrder, LetsFansGrowTogetherHoweverTheyAreNumbered) {
    Faces numbers(5);
    std::iota(numbers.begin(), numbers.end(), 0);
    do {
        Boundary boundary = slices(numbers);
        orderFaces(boundary);
        EXPECT_TRUE(growsTogether(boundary.parts[0].faces, numbers)) << testing::PrintToString(numbers);
        EXPECT_EQ(boundary.parts[0].faces.front(), 0);
    } while (std::ranges::next_permutation(numbers).found);
}

TEST(FaceOrder, LeavesOtherFacesInTheirOrder) {
    Boundary boundary = slices({0, 2, 1, 3});
    boundary.edges[2].isSmooth = false; // two fans of two faces: any order is right
    orderFaces(boundary);
    EXPECT_EQ(boundary.parts[0].faces, (Faces{0, 1, 2, 3}));
}

TEST(FaceOrder, IsNoMatterWhereSmoothFacesCloseAroundAVertex) {
    Boundary boundary = slices({0, 2, 1, 3});
    boundary.edges.pop_back();
    boundary.faces[3].loops = {{{3, true}, {0, false}}};
    boundary.edges[0].isSmooth = true;
    orderFaces(boundary);
    EXPECT_EQ(boundary.parts[0].faces, (Faces{0, 1, 2, 3}));
}

TEST(FaceOrder, HasPlanesBeforeCylinders) {
    Boundary boundary = slices({1, 0, 3, 2});
    boundary.faces[0].surface = aCylinder();
    boundary.faces[2].surface = aCylinder();
    orderFaces(boundary);
    // 0 comes between two others, which is unavoidable.
    EXPECT_EQ(boundary.parts[0].faces, (Faces{1, 3, 0, 2}));
}

TEST(FaceOrder, KeepsPartsApart) {
    Boundary boundary = slices({0, 2, 1, 3});
    boundary.edges[2].isSmooth = false;
    boundary.parts = {{{1, 3}}, {{2, 0}}};
    orderFaces(boundary);
    EXPECT_EQ(boundary.parts[0].faces, (Faces{1, 3}));
    EXPECT_EQ(boundary.parts[1].faces, (Faces{0, 2}));
}

} // namespace
} // namespace qm
