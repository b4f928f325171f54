#include "mesh/nesting.h"
#include "mesh/suspicions.h"
#include "shape/shape.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace qm {
namespace {

/// Sample meshes as the parts of one.
class Parts {
public:
    /// \param name  empty for a part that is not closed
    Parts& add(const std::string& name, double scale, const Point& to, bool inwards) {
        std::vector<FaceId>& faces = faces_.emplace_back();
        if (name.empty()) return *this;
        const QuadMesh sample = makeShape(name);
        const auto first = static_cast<int>(mesh_.n_vertices());
        for (const VertexId vertex : sample.vertices())
            mesh_.add_vertex(scale * sample.point(vertex) + to);
        for (const FaceId face : sample.faces()) {
            std::vector<VertexId> corners;
            for (const VertexId vertex : sample.fv_range(face))
                corners.emplace_back(first + vertex.idx());
            if (inwards) std::ranges::reverse(corners);
            faces.push_back(mesh_.add_face(corners));
        }
        return *this;
    }
    Parts& out(double radius) { return add("sphere", radius, {0, 0, 0}, false); }
    Parts& in(double radius, const Point& to = {0, 0, 0}) { return add("sphere", radius, to, true); }

    [[nodiscard]] std::vector<std::string> warnings() const { return suspicions(mesh_); }
    [[nodiscard]] std::vector<Nesting> nesting() const { return nestingOf(mesh_, faces_); }
    [[nodiscard]] std::vector<std::optional<std::size_t>> cavities() const {
        std::vector<std::optional<std::size_t>> result;
        for (const Nesting& one : nesting())
            result.push_back(one.cavityOf);
        return result;
    }

private:
    QuadMesh mesh_;
    std::vector<std::vector<FaceId>> faces_;
};

using Of = std::vector<std::optional<std::size_t>>;

TEST(Nesting, CavitiesAreInsideAndLookTheOtherWay) {
    EXPECT_EQ(Parts().out(2).in(1).cavities(), (Of{{}, 0}));
    EXPECT_EQ(Parts().in(1).out(2).cavities(), (Of{1, {}})) << "in any order";
    EXPECT_EQ(Parts().out(2).out(1).cavities(), (Of{{}, {}})) << "two solids";
    EXPECT_EQ(Parts().out(2).in(1, {5, 0, 0}).cavities(), (Of{{}, {}})) << "beside";
    const Parts withOpen = Parts().out(1).add("", 1, {}, false).add("cube", 0.2, {-0.1, 0.3, 0.2}, true);
    EXPECT_EQ(withOpen.cavities(), (Of{{}, {}, 0}));
}

TEST(Nesting, WhatLiesInACavityIsASolid) {
    EXPECT_EQ(Parts().out(4).in(3).out(2).in(1).cavities(), (Of{{}, 0, {}, 2}));
    const std::vector<Nesting> turned = Parts().out(4).in(3).in(2).nesting();
    EXPECT_FALSE(turned[2].cavityOf);
    EXPECT_TRUE(turned[2].inward);
}

TEST(Nesting, AMeshThatIsInsideOutIsTurnedWithItsCavities) {
    const std::vector<Nesting> nesting = Parts().in(2).out(1).nesting();
    EXPECT_TRUE(nesting[0].inward);
    EXPECT_EQ(nesting[1].cavityOf, 0U);
    EXPECT_TRUE(nesting[1].inward);
}

TEST(Nesting, ComponentsThatAreInsideOutAreWarnedOf) {
    const auto only = [](const Parts& parts) {
        const std::vector<std::string> warnings = parts.warnings();
        EXPECT_EQ(warnings.size(), 1U);
        return warnings.empty() ? "" : warnings.front();
    };
    EXPECT_EQ(Parts().out(2).in(1).warnings(), std::vector<std::string>());
    EXPECT_TRUE(only(Parts().add("cube", 1, {5, 0, 0}, false).in(1))
                    .starts_with("a closed component is inside out, that of face 384."));
    EXPECT_TRUE(only(Parts().in(2).out(1))
                    .starts_with("2 closed components are inside out, the first is that of face 0."));
}

TEST(Nesting, TheHoleOfARingIsNotInside) {
    const Parts ring = Parts().add("torus", 1, {0, 0, 0}, false); // of radius 3
    EXPECT_EQ(Parts(ring).in(0.3).cavities(), (Of{{}, {}}));
    EXPECT_EQ(Parts(ring).in(0.3, {3, 0, 0}).cavities(), (Of{{}, 0}));
}

TEST(Nesting, ManyCavitiesAreFoundAtOnce) {
    Parts parts;
    parts.add("cube", 20, {-10, -10, -10}, false);
    for (int i = 0; i < 10; ++i)
        for (int j = 0; j < 20; ++j)
            parts.in(0.3, {i - 4.5, 0.9 * j - 9, 0.1});
    EXPECT_EQ(std::ranges::count(parts.cavities(), std::optional<std::size_t>(0)), 200);
}

} // namespace
} // namespace qm
