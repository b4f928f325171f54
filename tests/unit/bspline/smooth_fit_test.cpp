#include "base/infinity.h"
#include "basecomplex/base_complex.h"
#include "bspline/fit.h"
#include "bspline/fitting/energy/gram.h"
#include "bspline/fitting/knots/knot_plan.h"
#include "bspline/fitting/lattice/normal_limits.h"
#include "bspline/fitting/system/smooth_system.h"
#include "bspline/network/creases.h"
#include "bspline/network/smooth_network.h"
#include "bspline/network/vertex_fan.h"
#include "bspline/reference/lattice/bilinear_quad.h"
#include "bspline/reference/lattice/sound_faces.h"
#include "bspline/reference/limit/limit_surface.h"
#include "bspline/solver/constrained_system.h"
#include "bspline/splines/bezier_extraction.h"
#include "bspline/splines/interpolate.h"
#include "mesh/bounding_box.h"
#include "mesh/dihedral.h"
#include "shape/shape.h"
#include "support/cheapest_layout.h"
#include "support/fitted_model.h"
#include "support/grid_layout.h"
#include "support/network_of.h"
#include "support/quad_layout.h"
#include "support/star_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

namespace qm {
namespace {

using test::Grid;
using test::networkOf;

/// A sheet with a right-angle bend at i = 4.
Grid folded() {
    return {8, 6, [](double i, double j) { return Point(std::min(i, 4.0), j, std::max(i - 4, 0.0)); }};
}

TEST(TangentRatio, FallsToZeroWithinItsReachAndIsSmoothThere) {
    TangentRatio ratio;
    ratio.atEnd = {2, -1};
    ratio.reach = {2, 1};
    ratio.length = 5;
    EXPECT_EQ(ratio(0), 2);
    EXPECT_EQ(ratio(1), 0.5);
    EXPECT_EQ(ratio(3), 0);
    EXPECT_EQ(ratio(5), -1);
    EXPECT_NEAR((ratio(2) - ratio(2 - 1e-6)) / 1e-6, 0, 1e-5);
    ratio.isLinear = true;
    EXPECT_DOUBLE_EQ(ratio(2.5), 0.5);
}

TEST(VertexFan, KnowsWhereSidesPassStraightThrough) {
    const QuadMesh mesh = test::makeMesh(test::sheet());
    const Layout layout = test::makeLayout(test::sheet(), test::tJoint());
    const SmoothNetwork network = networkOf(mesh, layout);
    const VertexId joint(3 * 11 + 6); // where two rectangles meet the side of the third
    const VertexFan fan = vertexFan(mesh, network.marks, joint);
    ASSERT_EQ(fan.faces.size(), 3U);
    EXPECT_TRUE(fan.isClosed);
    EXPECT_EQ(std::ranges::count(fan.faces, 2), 1);
    for (const double ratio : tangentRatios(mesh, fan, network.rules[static_cast<std::size_t>(joint.idx())]))
        EXPECT_EQ(ratio, 0) << "all is regular there";
}

TEST(VertexFan, ManyEdgesShareOneTurn) {
    // With any other ratio no edges but those without length would close around the vertex.
    for (const int quads : {5, 62, 63, 1000}) {
        const QuadMesh mesh = test::star(quads);
        const SmoothNetwork network = networkOf(mesh, test::segmentPerQuad(mesh));
        const auto ratios = tangentRatios(mesh, vertexFan(mesh, network.marks, VertexId(0)), {});
        ASSERT_EQ(ratios.size(), static_cast<std::size_t>(quads));
        for (const double ratio : ratios)
            EXPECT_NEAR(ratio, 2 * std::cos(2 * std::numbers::pi / quads), 1e-12) << quads;
    }
}

TEST(Creases, ShortCurvesThatEndInNothingAreNoise) {
    // A sheet of two patches with a ridge along their border j = 3, from i = `from` to i = `to`.
    const auto creasesOf = [](double from, double to, double height) {
        const Grid grid{12, 6, [=](double i, double j) {
                            const bool isRidge = i > from && i < to;
                            return Point(i, j, isRidge ? -height * std::abs(j - 3) : 0);
                        }};
        const QuadMesh mesh = test::makeMesh(grid);
        const Layout layout = test::makeLayout(grid, {{0, 0, 12, 3}, {0, 3, 12, 6}});
        const auto isCrease =
            markBorders(mesh, borderEdges(mesh, layout), dihedralAngles(mesh), 0.45).isCrease;
        std::size_t inside = 0;
        for (const EdgeId edge : mesh.edges())
            if (isCrease[static_cast<std::size_t>(edge.idx())] && !mesh.is_boundary(edge)) ++inside;
        return inside;
    };
    EXPECT_EQ(creasesOf(3.5, 6.5, 0.4), 0U) << "a few edges";
    EXPECT_GT(creasesOf(3.5, 6.5, 2), 0U) << "sharp beyond doubt";
    EXPECT_GT(creasesOf(2.5, 9.5, 0.4), 4U) << "a long one";
    EXPECT_EQ(creasesOf(-1, 13, 0.4), 12U) << "from boundary to boundary";
}

TEST(Creases, GoOnWhereTheyAreAlmostSharpAsFarAsTheNextOnes) {
    // The dihedral angles along the border of two patches are given; rho is 0.6.
    const auto creasesOf = [](const std::vector<double>& along) {
        const Grid grid{static_cast<int>(along.size()), 2, [](double i, double j) { return Point(i, j, 0); }};
        const QuadMesh mesh = test::makeMesh(grid);
        const Layout layout = test::makeLayout(grid, {{0, 0, grid.columns, 1}, {0, 1, grid.columns, 2}});
        std::vector<double> angles(mesh.n_edges());
        const auto edge = [&](std::size_t k) {
            const int vertex = grid.columns + 1 + static_cast<int>(k);
            return static_cast<std::size_t>(
                mesh.edge_handle(mesh.find_halfedge(VertexId(vertex), VertexId(vertex + 1))).idx());
        };
        for (std::size_t k = 0; k < along.size(); ++k)
            angles[edge(k)] = along[k];
        const BorderMarks marks = markBorders(mesh, borderEdges(mesh, layout), angles, 0.6);
        std::string creases;
        for (std::size_t k = 0; k < along.size(); ++k)
            creases += marks.isCrease[edge(k)] ? 'c' : '-';
        return creases;
    };
    EXPECT_EQ(creasesOf({0.7, 0.4, 0.5, 0.7, 0.7, 0.4}), "cccccc") << "gaps, and the boundary behind";
    EXPECT_EQ(creasesOf({0.4, 0.4, 0.5, 0.4, 0.4, 0.5}), "------") << "nothing to go on from";
    EXPECT_EQ(creasesOf({2, 0.4, 0.2, 0.4, 0.4, 2}), "c----c") << "too flat on the way";
    EXPECT_EQ(creasesOf({0.1, 0.4, 2, 0.5, 0.2, 2}), "--c--c") << "on neither side as far as another";
}

TEST(Creases, WhereTwoMeetAtACornerTheSharpestOtherBorderIsAThird) {
    const auto creasesOf = [](int quads, const std::vector<double>& spokes) {
        const QuadMesh mesh = test::star(quads);
        std::vector<double> angles(mesh.n_edges());
        const auto spoke = [&](std::size_t k) {
            return static_cast<std::size_t>(
                mesh.edge_handle(mesh.find_halfedge(VertexId(0), VertexId(1 + static_cast<int>(k)))).idx());
        };
        for (std::size_t k = 0; k < spokes.size(); ++k)
            angles[spoke(k)] = spokes[k];
        const auto borders = borderEdges(mesh, test::segmentPerQuad(mesh));
        const BorderMarks marks = markBorders(mesh, borders, angles, 0.6);
        std::string creases;
        for (std::size_t k = 0; k < spokes.size(); ++k)
            creases += marks.isCrease[spoke(k)] ? 'c' : '-';
        return creases;
    };
    EXPECT_EQ(creasesOf(3, {1, 1, 0.4}), "ccc");
    EXPECT_EQ(creasesOf(3, {1, 1, 0.2}), "cc-") << "too flat";
    EXPECT_EQ(creasesOf(5, {1, 1, 0.1, 0.4, 0.5}), "cc-cc") << "all that lead to the boundary";
    EXPECT_EQ(creasesOf(6, {1, 0.4, 0.4, 1, 0.4, 0.4}), "c--c--") << "one curve, straight on";
    EXPECT_EQ(creasesOf(8, {1, 0.2, 1, 0.4, 0.2, 0.5, 0.2, 0.4}), "c-cc-c-c")
        << "a curve that turns too much";
}

TEST(Creases, AtACornerOfTwoTheCornersOfQuadsTellHowSharpABorderIs) {
    // The quads beside the first border are twisted: their means differ by 0.09, their corners here by 0.76.
    QuadMesh mesh = test::star(3);
    const std::array<Point, 6> around = {Point(-1, 0, 0),      Point(0.2, -0.6, 0.3),
                                         Point(0.2, 1, 0.3),   Point(-0.8, -0.6, -0.1),
                                         Point(0.4, 0.4, 1.2), Point(-0.8, 1, -0.3)};
    for (std::size_t k = 0; k < around.size(); ++k)
        mesh.set_point(VertexId(1 + static_cast<int>(k)), around[k]);
    mesh.set_point(VertexId(0), Point(0, 0, 0));
    const std::vector<double> angles = dihedralAngles(mesh);
    const auto spoke = [&](int k) {
        return static_cast<std::size_t>(
            mesh.edge_handle(mesh.find_halfedge(VertexId(0), VertexId(1 + k))).idx());
    };
    EXPECT_LT(angles[spoke(0)], 0.1);
    const BorderMarks marks = markBorders(mesh, borderEdges(mesh, test::segmentPerQuad(mesh)), angles, 0.6);
    for (int k = 0; k < 3; ++k)
        EXPECT_TRUE(marks.isCrease[spoke(k)]);
}

TEST(Creases, WhereThreeMeetAreAllBordersAtWhichQuadsAreBent) {
    // Three of four edges at a vertex are creases by their angles. At the third edge, quads are bent by their
    // corners alone, as the edges on both sides of it rise.
    const auto isThirdCrease = [](double rise, double turn) {
        QuadMesh mesh = test::star(turn < 360 ? 3 : 4, turn);
        const auto spoke = [&](int k) {
            return static_cast<std::size_t>(
                mesh.edge_handle(mesh.find_halfedge(VertexId(0), VertexId(1 + k))).idx());
        };
        for (const int k : {1, 3})
            mesh.set_point(VertexId(1 + k), mesh.point(VertexId(1 + k)) + Point(0, 0, rise));
        std::vector<double> angles(mesh.n_edges());
        angles[spoke(1)] = angles[spoke(3)] = angles[spoke(turn < 360 ? 1 : 0)] = 1;
        const BorderMarks marks =
            markBorders(mesh, borderEdges(mesh, test::segmentPerQuad(mesh)), angles, 0.6);
        return marks.isCrease[spoke(2)];
    };
    EXPECT_TRUE(isThirdCrease(0.5, 360)) << "by 0.93";
    EXPECT_FALSE(isThirdCrease(0.25, 360)) << "by 0.49";
    EXPECT_TRUE(isThirdCrease(0.5, 270)) << "two of them on the boundary";
    EXPECT_FALSE(isThirdCrease(0.25, 270));
}

TEST(Creases, OfACornerThatLeadNowhereOnlyTheSharpestCounts) {
    const Grid grid{8, 8, [](double i, double j) { return Point(i, j, 0); }};
    const QuadMesh mesh = test::makeMesh(grid);
    const Layout layout = test::makeLayout(grid, {{0, 0, 4, 4}, {4, 0, 8, 4}, {0, 4, 4, 8}, {4, 4, 8, 8}});
    std::vector<double> angles(mesh.n_edges());
    const auto edge = [&](int vertex, int step) {
        return static_cast<std::size_t>(
            mesh.edge_handle(mesh.find_halfedge(VertexId(vertex), VertexId(vertex + step))).idx());
    };
    const int center = 4 * 9 + 4;
    for (int k = 0; k < 4; ++k)
        angles[edge(center - k - 1, 1)] = angles[edge(center - 9 * (k + 1), 9)] = 1;
    angles[edge(center, 1)] = 0.4;
    angles[edge(center, 9)] = 0.5;
    const BorderMarks marks = markBorders(mesh, borderEdges(mesh, layout), angles, 0.6);
    EXPECT_FALSE(marks.isCrease[edge(center, 1)]);
    EXPECT_TRUE(marks.isCrease[edge(center, 9)]);
}

TEST(VertexFan, RatiosAtCornersAgreeWithTheMeshsDirections) {
    // A corner of a sheet with two quads at angles of 45 and 90 degrees and edges of different lengths.
    const Grid grid{2, 1, [](double i, double j) {
                        const std::array<std::array<Point, 3>, 2> places{
                            {{Point(1, 0, 0), Point(0, 0, 0), Point(-2, 2, 0)},
                             {Point(2, 2, 0), Point(1.5, 1.5, 0), Point(-1, 4, 0)}}};
                        return places[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)];
                    }};
    const QuadMesh mesh = test::makeMesh(grid);
    const Layout layout = test::makeLayout(grid, {{0, 0, 1, 1}, {1, 0, 2, 1}});
    const SmoothNetwork network = networkOf(mesh, layout);
    const VertexId corner(1);
    const VertexFan fan = vertexFan(mesh, network.marks, corner);
    const auto ratios = tangentRatios(mesh, fan, {VertexRule::Kind::corner});
    ASSERT_EQ(ratios.size(), 3U);
    // Edges at 0, 45 and 135 degrees: lengths a, b, c with a sin 45 = c sin 90, and a c = 1 * sqrt 8.
    const double a = std::sqrt(std::sqrt(8.0) / std::sqrt(0.5));
    EXPECT_NEAR(ratios[1], a * std::sqrt(0.5) / (1.5 * std::sqrt(2.0)), 1e-12);
    EXPECT_EQ(ratios[0], 0);
    EXPECT_EQ(ratios[2], 0);
}

TEST(SmoothNetwork, StretchesEndAtTJoints) {
    const QuadMesh mesh = test::makeMesh(test::sheet());
    const SmoothNetwork network = networkOf(mesh, test::makeLayout(test::sheet(), test::tJoint()));
    std::vector<int> lengths;
    for (const Stretch& stretch : network.stretches)
        lengths.push_back(stretch.length());
    std::ranges::sort(lengths);
    EXPECT_EQ(lengths, (std::vector<int>{4, 5, 6}));
    EXPECT_EQ(network.runs.size(), 3U);
}

TEST(SmoothNetwork, CreasesAreNoRuns) {
    const QuadMesh mesh = test::makeMesh(folded());
    const SmoothNetwork network = networkOf(mesh, test::makeLayout(folded(), {{0, 0, 4, 6}, {4, 0, 8, 6}}));
    EXPECT_EQ(network.stretches.size(), 1U);
    EXPECT_TRUE(network.runs.empty());
}

TEST(Gram, IntegratesProductsOfSplinesExactly) {
    const std::vector<double> knots = {0, 0, 0, 0, 1, 2.5, 2.5, 4, 4, 4, 4};
    const auto pieces = gramPieces(knots);
    std::vector<std::size_t> quads;
    quads.reserve(pieces.size());
    for (const GramPiece& piece : pieces)
        quads.push_back(piece.quad);
    EXPECT_EQ(quads, (std::vector<std::size_t>{0, 1, 2, 2, 3}));
    // With control points at the mean of their knots, the spline is the identity, with slope one and no
    // bending.
    std::vector<double> identity;
    for (std::size_t k = 0; k + 4 < knots.size(); ++k)
        identity.push_back((knots[k + 1] + knots[k + 2] + knots[k + 3]) / 3);
    const std::vector<double> ones(identity.size(), 1);
    const auto energy = [&](Matrix4 GramPiece::*matrix, const std::vector<double>& controls) {
        double result = 0;
        for (const GramPiece& piece : pieces)
            for (std::size_t i = 0; i < 4; ++i)
                for (std::size_t k = 0; k < 4; ++k)
                    result += (piece.*matrix)[i][k] * controls[piece.first + i] * controls[piece.first + k];
        return result;
    };
    EXPECT_NEAR(energy(&GramPiece::values, ones), 4, 1e-13);
    EXPECT_NEAR(energy(&GramPiece::values, identity), 64. / 3, 1e-12);
    EXPECT_NEAR(energy(&GramPiece::slopes, identity), 4, 1e-12);
    EXPECT_NEAR(energy(&GramPiece::bends, identity), 0, 1e-9);
}

/// A matrix that is diagonal.
Eigen::SparseMatrix<double> diagonalMatrix(const Eigen::VectorXd& diagonal) {
    return Eigen::SparseMatrix<double>(diagonal.asDiagonal());
}

TEST(ConstrainedSystem, KeepsEquationsThatSayTheSameTwice) {
    LinearForm first;
    first.add(0, 1);
    first.add(1, -1);
    LinearForm second; // twice the first
    second.add(0, 2);
    second.add(1, -2);
    LinearForm third;
    third.add(1, 1);
    third.add(3, 1);
    const ConstrainedSystem system({diagonalMatrix(Eigen::Vector4d(1, 2, 3, 4))}, {first, second, third}, {},
                                   1);
    Eigen::MatrixX3d right = Eigen::MatrixX3d::Zero(4, 3);
    right.col(0) << 3, -1, 2, 5;
    Eigen::MatrixX3d x;
    system.improve(right, Accuracy::rounding, x);
    EXPECT_NEAR(x(0, 0), x(1, 0), 1e-14);
    EXPECT_NEAR(x(1, 0), -x(3, 0), 1e-14);
    // With x0 = x1 = -x3 = t the form is (1 + 2 + 4) t^2 / 2 - (3 - 1 - 5) t.
    EXPECT_NEAR(x(0, 0), -3.0 / 7, 1e-12);
    EXPECT_NEAR(x(2, 0), 2.0 / 3, 1e-12);
}

TEST(ConstrainedSystem, KeepsEquationsWithConstants) {
    LinearForm sum;
    sum.add(0, 1);
    sum.add(1, 1);
    Eigen::MatrixX3d constants(1, 3);
    constants << 2, 0, -4;
    // Two blocks: the equation joins them.
    const ConstrainedSystem system(
        {diagonalMatrix(Eigen::VectorXd::Ones(1)), diagonalMatrix(Eigen::VectorXd::Ones(2))}, {sum},
        constants, 1);
    Eigen::MatrixX3d x;
    system.improve(Eigen::MatrixX3d::Zero(3, 3), Accuracy::rounding, x);
    EXPECT_NEAR(x(0, 0), 1, 1e-14);
    EXPECT_NEAR(x(1, 2), -2, 1e-14);
    EXPECT_NEAR(x(2, 0), 0, 1e-14);
    EXPECT_LT(system.violation(x), 1e-14);
    EXPECT_GT(system.violation(2 * x), 0.1);
}

TEST(SmoothSystem, FindsTheSamePatchWhileItsNeighboursStay) {
    const QuadMesh mesh = test::makeMesh(test::sheet());
    const Layout layout = test::makeLayout(test::sheet(), test::tJoint());
    const SmoothNetwork network = networkOf(mesh, layout);
    const FitTarget target{limitSurface(mesh, layout, network.sharpness(), 4, 1)};
    const auto sources = latticeSources(mesh, layout, network, target, 1);
    const KnotPlan plan(layout, network);
    const std::vector<PatchSpace> spaces = plan.spaces();
    std::vector<FitLattice> lattices;
    std::vector<std::vector<ThinPlate>> plates;
    for (std::size_t k = 0; k < sources.size(); ++k) {
        lattices.push_back(makeLattice(sources[k], {latticeParameters(layout.segments[k].size[0], 4, {}),
                                                    latticeParameters(layout.segments[k].size[1], 4, {})}));
        plates.push_back(thinPlates(target.grids[k], sources[k].isStiff, 0.1));
    }
    const auto solve = [&](const std::vector<bool>& isFree, std::vector<Patch>& patches) {
        SmoothSystem system(plan, spaces, lattices, plates, isFree, patches, 1);
        system.solve(lattices, Accuracy::rounding, patches);
        return system.holds();
    };
    std::vector<Patch> all(sources.size());
    EXPECT_TRUE(solve(std::vector<bool>(sources.size(), true), all));
    for (std::size_t free = 0; free < sources.size(); ++free) {
        std::vector<bool> isFree(sources.size());
        isFree[free] = true;
        std::vector<Patch> patches = all;
        patches[free] = {};
        EXPECT_TRUE(solve(isFree, patches));
        for (std::size_t k = 0; k < all[free].controlPoints.size(); ++k)
            EXPECT_LT((patches[free].controlPoints[k] - all[free].controlPoints[k]).norm(), 1e-9);
    }
    // If the patches that stay do not meet each other, no patch can meet them all, however large it becomes.
    for (Point& point : all[1].controlPoints)
        point += Point(0, 0, 1);
    EXPECT_FALSE(solve({true, false, false}, all));
}

TEST(SoundFaces, AreFlatAndConvexAndHaveNoFoldBesideThem) {
    const auto soundWith = [](const Point& moved) { // moves vertex (3, 1) of a flat sheet
        const QuadMesh mesh = test::makeMesh(
            Grid{6, 2, [&](double i, double j) { return i == 3 && j == 1 ? moved : Point(i, j, 0); }});
        return soundFaces(mesh, 1);
    };
    EXPECT_EQ(std::ranges::count(soundWith({3, 1, 0}), true), 12);
    EXPECT_EQ(std::ranges::count(soundWith({3, 1, 0.8}), true), 8) << "the four around it are not flat";
    EXPECT_EQ(std::ranges::count(soundWith({4.5, 1, 0}), true), 6) << "those beside a folded one are not";
}

TEST(BilinearQuad, HasItsCornersAndTheirNormals) {
    const BilinearQuad quad({Point(0, 0, 0), Point(2, 0, 0), Point(2, 1, 1), Point(0, 1, 0)});
    EXPECT_EQ(quad.evaluate(1, 1).position, Point(2, 1, 1));
    EXPECT_EQ(quad.evaluate(0.5, 0.5).position, Point(1, 0.5, 0.25));
    EXPECT_EQ(quad.evaluate(1, 0).dv, Point(0, 1, 1));
    EXPECT_LT(quad.minCosine(), 0.95);
    EXPECT_DOUBLE_EQ(
        BilinearQuad({Point(0, 0, 0), Point(1, 0, 0), Point(3, 2, 0), Point(0, 1, 0)}).minCosine(), 1);
}

TEST(NormalLimits, AreWideOnlyWhereTheNormalTurnsUnevenly) {
    // An arc of 12 degrees per step along u, with one displaced point in its middle.
    const auto limitsWith = [](double off) {
        ReferenceGrid grid{.size = {8, 2}, .steps = 1};
        for (int j = 0; j <= 2; ++j)
            for (int i = 0; i <= 8; ++i) {
                const double angle = 12 * i * std::numbers::pi / 180;
                const double radius = i == 6 ? 1 + off : 1;
                grid.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), j);
            }
        return NormalLimits(grid);
    };
    const double degree = std::numbers::pi / 180;
    EXPECT_NEAR(limitsWith(0).at(1, {4, 1}) / degree, 0.1, 1e-12) << "straight";
    EXPECT_NEAR(limitsWith(0).at(0, {3.4, 1}) / degree, 0.1, 1e-12) << "even";
    EXPECT_NEAR(limitsWith(0.01).at(0, {2, 1}) / degree, 0.1, 1e-12) << "even there";
    EXPECT_GT(limitsWith(0.01).at(0, {6, 1}) / degree, 2);
    EXPECT_LT(limitsWith(0).onCrease(0, {3, 0}) / degree, 0.1) << "creases that turn evenly";
    EXPECT_GT(limitsWith(0.01).onCrease(0, {6, 0}) / degree, 2);
}

TEST(NormalLimits, OfLatticeLinesAreThoseOfCreasesAlongThese) {
    ReferenceGrid grid{.size = {3, 3}, .steps = 1};
    for (int j = 0; j <= 3; ++j)
        for (int i = 0; i <= 3; ++i)
            grid.points.emplace_back(i, j, 0);
    LatticeSource source{.grid = &grid};
    source.isCrease[0].assign(3, true); // the side v = 0
    for (std::size_t side = 1; side < 4; ++side)
        source.isCrease[side].assign(3, false);
    source.isSound.assign(9, true);
    const FitLattice lattice = makeLattice(source, {gridLines(3), gridLines(3)});
    const NormalLimits limits(grid);
    EXPECT_EQ(limits.at(lattice, 0, 0, 1), limits.onCrease(0, {1, 0}));
    EXPECT_EQ(limits.at(lattice, 0, 1, 1), limits.at(0, {1, 1})) << "a line beside the crease";
    EXPECT_EQ(limits.at(lattice, 1, 1, 0), infinity) << "a line that ends at the crease";
    EXPECT_EQ(limits.at(lattice, 1, 1, 1), limits.at(1, {1, 1}));
}

TEST(SmoothFit, FollowsNormalsThatTurnEvenly) {
    const QuadMesh mesh = makeShape("torus", {.around = 30});
    const Surfaces surfaces = fitSurfaces(mesh, test::cheapestLayout(mesh), dihedralAngles(mesh), {});
    EXPECT_LT(surfaces.deviation.maxRelative, 1e-3);
    EXPECT_LT(surfaces.deviation.largestNormalDeviation, 0.2) << "the tolerance alone lets it be 2 degrees";
    EXPECT_LT(controlPointCount(surfaces.patches), 250U);
}

TEST(SmoothFit, FollowsCreasesThatTurnEvenly) {
    // A flat ring, and a cylinder that hangs from its outer rim: 12 degrees an edge.
    const test::Grid hat{30, 6,
                         [](double i, double j) {
                             const double angle = 12 * i * std::numbers::pi / 180;
                             const double radius = std::min(1.0, 0.6 + 0.2 * j);
                             return Point(radius * std::cos(angle), radius * std::sin(angle),
                                          std::min(0.0, 0.2 * (2 - j)));
                         },
                         true};
    const std::vector<test::Rectangle> halves{{0, 0, 15, 2}, {15, 0, 30, 2}, {0, 2, 15, 6}, {15, 2, 30, 6}};
    const Surfaces surfaces = test::fitted(hat, halves, {}).surfaces;
    EXPECT_LT(surfaces.deviation.maxRelative, 1e-3);
    EXPECT_LT(surfaces.deviation.largestNormalDeviation, 0.2) << "the crease may wave along itself";
}

TEST(SmoothFit, IsSmoothAcrossTJointsAndWithinTheTolerance) {
    for (const double percent : {1.0, 0.1, 0.01, 5e-4}) {
        FitOptions options;
        options.tolerance = {percent, true};
        const Surfaces surfaces = test::fitted(test::sheet(), test::tJoint(), options).surfaces;
        EXPECT_LE(surfaces.deviation.maxRelative, percent / 100);
        EXPECT_LT(surfaces.deviation.largestGapRelative, 1e-13);
        EXPECT_LT(surfaces.deviation.largestNormalAngle, 1e-9);
        EXPECT_EQ(surfaces.deviation.folds, 0U);
        EXPECT_TRUE(missedTolerance(surfaces, options).empty());
    }
}

TEST(SmoothFit, TakesFewerControlPointsForLooserTolerances) {
    std::size_t before = std::numeric_limits<std::size_t>::max();
    for (const double percent : {0.01, 0.1, 1.0}) {
        FitOptions options;
        options.tolerance = {percent, true};
        const std::size_t points =
            controlPointCount(test::fitted(test::sheet(), test::tJoint(), options).surfaces.patches);
        EXPECT_LT(points, before);
        before = points;
    }
}

TEST(SmoothFit, KeepsCreasesSharpAndPlanesPlane) {
    const Surfaces surfaces = test::fitted(folded(), {{0, 0, 4, 6}, {4, 0, 8, 6}}, {}).surfaces;
    EXPECT_EQ(controlPointCount(surfaces.patches), 32U) << "one cubic each way";
    for (const Point& point : surfaces.patches[0].controlPoints)
        EXPECT_NEAR(point[2], 0, 1e-8);
    for (const Point& point : surfaces.patches[1].controlPoints)
        EXPECT_NEAR(point[0], 4, 1e-8);
}

TEST(SmoothFit, SaysWhereItMissesATolerance) {
    FitOptions options;
    options.tolerance = {1e-13, true};
    const Surfaces surfaces = test::fitted(test::sheet(), test::tJoint(), options).surfaces;
    EXPECT_NE(missedTolerance(surfaces, options).find("missed in patch"), std::string::npos);
}

TEST(SmoothFit, EndsWithWhatItHasWhenItIsStopped) {
    const QuadMesh mesh = test::makeMesh(test::sheet());
    const Layout layout = test::makeLayout(test::sheet(), test::tJoint());
    FitOptions options;
    options.tolerance = {0.001, true};
    const Surfaces whole = fitSurfaces(mesh, layout, dihedralAngles(mesh), options);
    Control stopped;
    stopped.stopRequested = [] { return true; };
    const Surfaces early = fitSurfaces(mesh, layout, dihedralAngles(mesh), options, nullptr, stopped);
    EXPECT_LT(controlPointCount(early.patches), controlPointCount(whole.patches));
    EXPECT_GT(early.deviation.max, whole.deviation.max);
    EXPECT_LT(early.deviation.largestGapRelative, 1e-13);
    EXPECT_LT(early.deviation.largestNormalAngle, 1e-9);
    EXPECT_FALSE(missedTolerance(early, options).empty());
}

TEST(SmoothFit, DoesNotDependOnWhereTheModelLies) {
    const QuadMesh mesh = makeShape("genus2", {});
    const Layout layout = test::cheapestLayout(mesh);
    const Surfaces here = fitSurfaces(mesh, layout, dihedralAngles(mesh), {});
    QuadMesh far = mesh;
    const Point moved(-4096, 2048, 8192); // hundreds of times the part's size
    for (const VertexId vertex : far.vertices())
        far.set_point(vertex, mesh.point(vertex) + moved);
    const Surfaces there = fitSurfaces(far, layout, dihedralAngles(far), {});
    EXPECT_EQ(controlPointCount(there.patches), controlPointCount(here.patches));
    EXPECT_NEAR(there.deviation.bendingRatio, here.deviation.bendingRatio, 1e-3);
    // Both sides of a gap are rounded as coordinates are there.
    const double rounding = std::nextafter(moved[2], INFINITY) - moved[2];
    EXPECT_LT(there.deviation.largestGapRelative, 4 * rounding / boundingBox(far).diagonal());
    EXPECT_LT(there.deviation.largestNormalAngle, 1e-7);
}

TEST(SmoothFit, DoesNotDependOnTheNumberOfThreads) {
    const Grid waves{4, 3, [](double i, double j) { return Point(i, j, std::sin(2 * i) * std::cos(j)); }};
    Control several;
    several.jobs = 3;
    const auto compare = [&](const Grid& grid, const std::vector<test::Rectangle>& rectangles,
                             double percent) {
        const QuadMesh mesh = test::makeMesh(grid);
        const Layout layout = test::makeLayout(grid, rectangles);
        FitOptions options;
        options.tolerance = {percent, true};
        const auto one = fitSurfaces(mesh, layout, dihedralAngles(mesh), options);
        const auto three = fitSurfaces(mesh, layout, dihedralAngles(mesh), options, nullptr, several);
        for (std::size_t k = 0; k < one.patches.size(); ++k)
            EXPECT_EQ(one.patches[k].controlPoints, three.patches[k].controlPoints);
        return missedTolerance(one, options);
    };
    EXPECT_EQ(compare(test::sheet(), test::tJoint(), 0.1), "");
    EXPECT_NE(compare(waves, {{0, 0, 4, 3}}, 1e-5), "") << "all attempts are made";
}

/// Largest distance of points from the plane through three of them.
double offPlane(const std::vector<Point>& points) {
    const Point& origin = points.front();
    Point normal(0, 0, 0);
    for (const Point& a : points)
        for (const Point& b : {points.back(), points[points.size() / 3]})
            if (const Point n = (a - origin) % (b - origin); n.sqrnorm() > normal.sqrnorm()) normal = n;
    double farthest = 0;
    for (const Point& a : points)
        farthest = std::max(farthest, std::abs((a - origin) | normal) / normal.norm());
    return farthest;
}

/// A part turned so that none of its planes is parallel to an axis.
QuadMesh turnedShape(const std::string& name, int resolution) {
    QuadMesh mesh = makeShape(name, {.resolution = resolution});
    for (const VertexId vertex : mesh.vertices()) {
        const Point at = mesh.point(vertex);
        mesh.set_point(vertex, {0.6 * at[0] - 0.8 * at[1], 0.64 * at[0] + 0.48 * at[1] - 0.6 * at[2],
                                0.48 * at[0] + 0.36 * at[1] + 0.8 * at[2]});
    }
    return mesh;
}

TEST(PlanePatches, ArePlaneToRoundingAndStillSmooth) {
    const QuadMesh mesh = turnedShape("block", 4);
    const Layout layout = test::cheapestLayout(mesh);
    const Surfaces surfaces = fitSurfaces(mesh, layout, dihedralAngles(mesh), {});
    EXPECT_LT(surfaces.deviation.largestGapRelative, 1e-12);
    EXPECT_LT(surfaces.deviation.largestNormalAngle, 1e-6);
    EXPECT_LE(surfaces.deviation.maxRelative, 0.001);
    int planes = 0;
    for (const Patch& patch : surfaces.patches) {
        const Segment& segment = layout.segments[static_cast<std::size_t>(patch.segment.value())];
        if (offPlane(pointGrid(mesh, segment)) > 1e-9) continue;
        if (offPlane(patch.controlPoints) < 1e-12) ++planes;
    }
    EXPECT_EQ(planes, 4) << "but those with rounded corners";
}

TEST(PlanePatches, ArePlaneWhereTheirNeighboursNeedMoreKnotsForIt) {
    const QuadMesh mesh = turnedShape("bracket", 6);
    const Layout layout = test::cheapestLayout(mesh);
    const Surfaces surfaces = fitSurfaces(mesh, layout, dihedralAngles(mesh), {});
    EXPECT_LE(surfaces.deviation.maxRelative, 0.001);
    const auto planes = std::ranges::count_if(
        surfaces.patches, [](const Patch& patch) { return offPlane(patch.controlPoints) < 1e-12; });
    EXPECT_GT(planes, 20);
}

TEST(PlanePatches, HaveStraightSidesOnTheOutlineOfASheet) {
    const QuadMesh mesh = turnedShape("plate", 2);
    const Layout layout = test::cheapestLayout(mesh);
    const Surfaces surfaces = fitSurfaces(mesh, layout, dihedralAngles(mesh), {});
    EXPECT_LE(surfaces.deviation.maxRelative, 0.001);
    // The plate reaches from 0 to 5 and from 0 to 3, before it is turned.
    int onOutline = 0;
    for (const Patch& patch : surfaces.patches)
        for (const Point& at : patch.controlPoints) {
            const double x = 0.6 * at[0] + 0.64 * at[1] + 0.48 * at[2];
            const double y = -0.8 * at[0] + 0.48 * at[1] + 0.36 * at[2];
            for (const double beyond : {-x, x - 5, -y, y - 3}) {
                if (beyond < -0.05) continue;
                EXPECT_LT(std::abs(beyond), 1e-12);
                ++onOutline;
            }
        }
    EXPECT_GT(onOutline, 40);
}

} // namespace
} // namespace qm
