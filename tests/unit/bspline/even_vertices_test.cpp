#include "bspline/fitting/first_solution.h"
#include "bspline/fitting/fit_state.h"
#include "bspline/fitting/knots/even_vertices.h"
#include "bspline/fitting/knots/reach_alignment.h"
#include "support/network_of.h"
#include "support/quad_layout.h"
#include "support/star_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace qm {
namespace {

/// The height of the reference over a place of the plane.
using Height = std::function<double(double, double)>;

constexpr double height = 0.01;

/// Along the borders of six quads around a vertex it is the height times the cube of the distance, with
/// alternating signs.
double monkeySaddle(double x, double y) {
    return height * x * (x * x - 3 * y * y);
}

/// Quads that make a regular polygon, with a vertex in its middle and others in the middle of its sides.
QuadMesh polygon(int quads) {
    QuadMesh mesh = test::star(quads);
    const double radius = 1 / std::cos(std::numbers::pi / quads);
    for (int k = 1 + quads; k <= 2 * quads; ++k) {
        const VertexId corner(k);
        mesh.set_point(corner, mesh.point(corner).normalized() * radius);
    }
    return mesh;
}

/// The quads of a polygon, each of which is a patch, with a reference over them.
struct Star {
    Star(int quads, const Height& over)
        : mesh(polygon(quads)), layout(test::segmentPerQuad(mesh)), network(test::networkOf(mesh, layout)) {
        constexpr int steps = 4;
        for (const Segment& segment : layout.segments) {
            const auto corner = [&](std::size_t side) { return mesh.point(segment.sides[side].front()); };
            ReferenceGrid& grid = reference.grids.emplace_back(ReferenceGrid{.size = {1, 1}, .steps = steps});
            for (int j = 0; j <= steps; ++j)
                for (int i = 0; i <= steps; ++i) {
                    const double u = static_cast<double>(i) / steps;
                    const double v = static_cast<double>(j) / steps;
                    Point place = (1 - v) * ((1 - u) * corner(0) + u * corner(1)) +
                                  v * ((1 - u) * corner(3) + u * corner(2));
                    place[2] = over(place[0], place[1]);
                    grid.points.push_back(place);
                }
        }
    }

    [[nodiscard]] std::vector<EvenVertex> vertices() const {
        return evenVertices(mesh, network, reference.grids);
    }
    [[nodiscard]] double errorWith(const std::vector<double>& reaches) const {
        return minError(vertices().at(0), reaches);
    }

    QuadMesh mesh;
    Layout layout;
    SmoothNetwork network;
    FitTarget reference;
};

TEST(EvenVertices, AreThoseWithAnEvenNumberOfBordersThatHaveRatios) {
    const auto bordersWith = [](int quads) {
        std::vector<std::size_t> borders;
        for (const EvenVertex& vertex : Star(quads, monkeySaddle).vertices())
            borders.push_back(vertex.borders.size());
        return borders;
    };
    EXPECT_EQ(bordersWith(6), std::vector<std::size_t>{6});
    EXPECT_EQ(bordersWith(8), std::vector<std::size_t>{8});
    EXPECT_TRUE(bordersWith(3).empty());
    EXPECT_TRUE(bordersWith(4).empty());
    EXPECT_TRUE(bordersWith(5).empty());
}

TEST(EvenVertices, MissWhatRisesAndFallsInTurn) {
    const Star star(6, monkeySaddle);
    EXPECT_NEAR(star.errorWith(std::vector<double>(6, 1)), height, 0.001 * height);
    EXPECT_NEAR(star.errorWith(std::vector<double>(6, 0.5)), height / 8, 0.001 * height);
    EXPECT_NEAR(star.errorWith({0.25, 1, 1, 1, 1, 1}), height / 4, 0.001 * height)
        << "one border makes up for the others";
}

TEST(EvenVertices, MissNothingOfQuadrics) {
    const std::vector<double> reaches(6, 1);
    EXPECT_NEAR(Star(6, [](double x, double y) { return x * x + y * y; }).errorWith(reaches), 0, 1e-9);
    EXPECT_NEAR(Star(6, [](double x, double y) { return x * x - y * y; }).errorWith(reaches), 0, 1e-9);
}

TEST(EvenVertices, HaveShorterReachesInCommon) {
    const Star star(6, monkeySaddle);
    KnotPlan plan(star.layout, star.network);
    shortenAtEvenVertices(star.vertices(), 2 * height, plan);
    EXPECT_EQ(reachesAt(star.vertices().at(0), plan), std::vector<double>(6, 1)) << "near enough";
    shortenAtEvenVertices(star.vertices(), height / 4, plan);
    EXPECT_EQ(reachesAt(star.vertices().at(0), plan), std::vector<double>(6, 0.5));
    shortenAtEvenVertices(star.vertices(), 0, plan);
    EXPECT_EQ(reachesAt(star.vertices().at(0), plan), std::vector<double>(6, 0.125)) << "not shorter";
}

TEST(EvenVertices, ShortenNoMoreBordersThanNecessary) {
    const Star star(6, monkeySaddle);
    const double allowed = height / 2;
    KnotPlan plan(star.layout, star.network);
    alignReaches(plan, star.vertices(), allowed);
    const std::vector<double> reaches = reachesAt(star.vertices().at(0), plan);
    EXPECT_LE(star.errorWith(reaches), allowed);
    EXPECT_GE(std::ranges::count(reaches, 1.0), 1) << "these take no knot";
    EXPECT_GE(std::ranges::count(reaches, 0.5), 1);
}

TEST(EvenVertices, AreFollowedByTheFirstSolution) {
    const Star star(6, monkeySaddle);
    const Verification verify = [](const std::vector<Patch>& patches) {
        return std::vector<double>(patches.size());
    };
    SmoothFitOptions options;
    options.tolerance = height / 2;
    const FitProblem problem{star.mesh, star.layout, star.network, star.reference, verify};
    FitState state(problem, options, std::vector<bool>(6), 1);
    solveFirst(state, 2, [] { return false; });
    EXPECT_LE(state.errors().worst(), 1);
}

} // namespace
} // namespace qm
