#include "base/error.h"
#include "bspline/bounding_box.h"
#include "bspline/chains.h"
#include "bspline/closeness.h"
#include "bspline/curve_fit.h"
#include "bspline/deviation.h"
#include "bspline/evaluate.h"
#include "bspline/fit.h"
#include "bspline/knot_refinement.h"
#include "bspline/knot_sharing.h"
#include "mesh/dihedral.h"
#include "support/grid_layout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <ostream>
#include <utility>

namespace qm {
namespace {

using test::Grid;
using test::Rectangle;

Point wavy(double i, double j) {
    return {i + 0.2 * std::sin(j), j, std::sin(0.4 * i) * std::cos(0.3 * j)};
}

const Grid sheet{16, 12, wavy};
// A pinwheel: four chains that end on one another in a circle, around a fifth patch; turned in every way.
const std::vector<Rectangle> pinwheel = {
    {0, 0, 10, 4, 1}, {10, 0, 16, 8, 2}, {6, 8, 16, 12, 3}, {0, 4, 6, 12, 0}, {6, 4, 10, 8, 1}};

Grid tube() {
    return {24, 10,
            [](double i, double j) {
                const double angle = i * std::numbers::pi / 12;
                return Point((3 + 0.3 * std::sin(j)) * std::cos(angle),
                             (3 + 0.3 * std::sin(j)) * std::sin(angle), j);
            },
            true};
}
// Two rings, one split once, the other twice elsewhere.
const std::vector<Rectangle> rings = {{0, 0, 24, 4, 0}, {5, 4, 15, 10, 2}, {15, 4, 29, 10, 3}};

struct Case {
    const char* name;
    Grid grid;
    std::vector<Rectangle> rectangles;
};

void PrintTo(const Case& instance, std::ostream* stream) {
    *stream << instance.name;
}

class FitLayouts : public testing::TestWithParam<Case> {
protected:
    void SetUp() override {
        mesh = test::makeMesh(GetParam().grid);
        layout = test::makeLayout(GetParam().grid, GetParam().rectangles);
        angles.assign(mesh.n_edges(), 0.1);
    }

    QuadMesh mesh;
    Layout layout;
    std::vector<double> angles;
};

void expectInterpolates(const QuadMesh& mesh, const Layout& layout, const std::vector<Patch>& patches) {
    const double rounding = 1e-12 * (1 + boundingBoxDiagonal(mesh));
    for (std::size_t s = 0; s < patches.size(); ++s) {
        const auto vertices = vertexGrid(mesh, layout.segments[s]);
        const auto [a, b] = layout.segments[s].size;
        EXPECT_EQ(patches[s].segment, SegmentId(s));
        EXPECT_EQ(domain(patches[s])[0], (std::array<double, 2>{0, static_cast<double>(a)}));
        for (int j = 0; j <= b; ++j)
            for (int i = 0; i <= a; ++i) {
                const Point expected = mesh.point(vertices[static_cast<std::size_t>(j * (a + 1) + i)]);
                EXPECT_LE((evaluate(patches[s], i, j).position - expected).norm(), rounding)
                    << s << ": " << i << ' ' << j;
            }
    }
}

TEST_P(FitLayouts, InterpolatesAsInThePaper) {
    const Surfaces surfaces = fitSurfaces(mesh, layout, angles, {});
    expectInterpolates(mesh, layout, surfaces.patches);
    for (std::size_t s = 0; s < surfaces.patches.size(); ++s) {
        const auto [a, b] = layout.segments[s].size;
        EXPECT_EQ(surfaces.patches[s].count, (std::array{a + 3, b + 3}));
    }
    EXPECT_EQ(surfaces.ofPatch.size(), surfaces.patches.size());
}

TEST_P(FitLayouts, InterpolatesWatertightAndSmooth) {
    FitOptions options;
    options.watertight = true;
    const Surfaces surfaces = fitSurfaces(mesh, layout, angles, options);
    expectInterpolates(mesh, layout, surfaces.patches);
    EXPECT_LT(surfaces.deviation.largestGapRelative, 1e-13);
    EXPECT_LT(surfaces.deviation.largestKink, 1e-6);
    const Surfaces plain = fitSurfaces(mesh, layout, angles, {});
    if (layout.segments.size() > 1) {
        EXPECT_GT(plain.deviation.largestKink, 1);
    }
    EXPECT_LT(surfaces.deviation.max, 1.05 * plain.deviation.max);
}

TEST_P(FitLayouts, KeepsEveryTolerance) {
    const Surfaces interpolated = fitSurfaces(mesh, layout, angles, {});
    std::size_t last = 0;
    for (const double tolerance : {0.3, 0.1, 0.03, 0.01, 0.001}) {
        FitOptions options;
        options.fit = Fit::tolerance;
        options.tolerance = {tolerance, false};
        options.samplesPerEdge = 4;
        options.kinkBudget = 0;
        const Surfaces surfaces = fitSurfaces(mesh, layout, angles, options);
        EXPECT_LE(surfaces.deviation.max, tolerance);
        EXPECT_LT(surfaces.deviation.largestNormalDeviation, 60) << "patches do not fold";
        EXPECT_LT(surfaces.deviation.largestGapRelative, 1e-11);
        if (tolerance >= 0.03) { // closer, the facets are followed, in which there is more luck
            EXPECT_GE(1.05 * static_cast<double>(controlPointCount(surfaces.patches)),
                      static_cast<double>(last))
                << "a closer fit takes no fewer points, or hardly";
        }
        last = controlPointCount(surfaces.patches);
        if (tolerance == 0.3) {
            EXPECT_LE(last, controlPointCount(interpolated.patches));
        }
        for (std::size_t s = 0; s < surfaces.patches.size(); ++s) {
            const Patch& patch = surfaces.patches[s];
            const auto [a, b] = layout.segments[s].size;
            EXPECT_EQ(patch.segment, SegmentId(s));
            EXPECT_EQ(domain(patch)[0][1], a);
            EXPECT_EQ(domain(patch)[1][1], b);
            for (std::size_t d = 0; d < 2; ++d)
                EXPECT_EQ(patch.knots[d].size(),
                          static_cast<std::size_t>(patch.count[d] + patch.degree[d]) + 1);
            EXPECT_LT((evaluate(patch, 0, 0).position - mesh.point(layout.segments[s].corners[0])).norm(),
                      1e-10);
            EXPECT_LT((evaluate(patch, a, b).position - mesh.point(layout.segments[s].corners[2])).norm(),
                      1e-10);
        }
    }
}

TEST_P(FitLayouts, TakesAToleranceRelativeToTheDiagonalAndIsSmoothWithinIt) {
    FitOptions options;
    options.fit = Fit::tolerance;
    options.tolerance = {0.1, true};
    const Surfaces surfaces = fitSurfaces(mesh, layout, angles, options);
    EXPECT_LE(surfaces.deviation.maxRelative, 0.001);
    EXPECT_LT(surfaces.deviation.largestKink, 8);
}

TEST(KnotSharing, CountsWhatTheOppositeSideDoesNotHave) {
    const QuadMesh mesh = test::makeMesh(sheet);
    const Layout layout = test::makeLayout(sheet, {{0, 0, 16, 5}, {0, 5, 16, 12}});
    const Chains chains(mesh, layout);
    const KnotSharing sharing(chains, layout);
    // The border between the two patches, and the sides opposite, have lengths of 16.
    std::vector<SplineCurve> curves;
    std::size_t between = 0;
    for (std::size_t k = 0; k < chains.all().size(); ++k) {
        curves.push_back({bareKnots(chains.all()[k].length()), {}});
        if (chains.hasPatch(k, 0) && chains.hasPatch(k, 1)) between = k;
    }
    curves[between].knots = {0, 0, 0, 0, 4, 16, 16, 16, 16};
    const auto places = sharing.places(between, curves);
    ASSERT_EQ(places.size(), 1U);
    EXPECT_EQ(places[0].parameter, 4);
    EXPECT_EQ(places[0].cost, (5 + 3) + (7 + 3)) << "no other side has it: a column in both patches";
}

TEST_P(FitLayouts, DoesNotDependOnTheNumberOfThreads) {
    FitOptions options;
    options.watertight = true;
    Control control;
    const Surfaces one = fitSurfaces(mesh, layout, angles, options, control);
    control.jobs = 4;
    const Surfaces four = fitSurfaces(mesh, layout, angles, options, control);
    for (std::size_t s = 0; s < one.patches.size(); ++s)
        EXPECT_EQ(one.patches[s].controlPoints, four.patches[s].controlPoints);
    EXPECT_EQ(one.deviation.rms, four.deviation.rms);
}

INSTANTIATE_TEST_SUITE_P(
    Cases, FitLayouts,
    testing::Values(
        Case{"pinwheel", sheet, pinwheel}, Case{"rings", tube(), rings},
        Case{"whole", sheet, {{0, 0, 16, 12, 0}}},
        Case{"smallest", {4, 2, wavy}, {{0, 0, 1, 1}, {1, 0, 4, 1, 1}, {0, 1, 2, 2, 3}, {2, 1, 4, 2, 2}}}),
    [](const auto& instance) { return instance.param.name; });

TEST(Chains, RunPastTJointsAndEndOnOthers) {
    const QuadMesh mesh = test::makeMesh(sheet);
    const Layout layout = test::makeLayout(sheet, pinwheel);
    const Chains chains(mesh, layout);
    std::size_t edges = 0;
    std::size_t inner = 0;
    for (const BorderChain& chain : chains.all()) {
        edges += chain.halfedges.size();
        EXPECT_FALSE(chain.closed);
        if (!mesh.is_boundary(mesh.edge_handle(chain.halfedges.front()))) {
            ++inner;
            EXPECT_TRUE(chain.length() == 10 || chain.length() == 8) << "one whole side, past one T-joint";
        }
    }
    EXPECT_EQ(inner, 4U);
    EXPECT_EQ(edges, 56U + 2 * 10 + 2 * 8);
    for (std::size_t s = 0; s < layout.segments.size(); ++s)
        for (int side = 0; side < 4; ++side) {
            ASSERT_EQ(chains.pieces(s, side).size(), 1U);
            const SidePiece& piece = chains.pieces(s, side).front();
            const auto& vertices = layout.segments[s].sides[static_cast<std::size_t>(side)];
            EXPECT_EQ(piece.length + 1, static_cast<int>(vertices.size()));
            EXPECT_EQ(mesh.from_vertex_handle(chains.halfedge(piece.place)), vertices.front());
        }
}

TEST(Chains, KnowClosedOnes) {
    const Grid grid = tube();
    const QuadMesh mesh = test::makeMesh(grid);
    const Chains chains(mesh, test::makeLayout(grid, rings));
    int closed = 0;
    for (const BorderChain& chain : chains.all())
        closed += chain.closed ? 1 : 0;
    EXPECT_EQ(closed, 1) << "the ring in the middle; those at the ends are open where their patches begin";
}

TEST(Fit, KeepsSharpEdgesSharpAndTheRestSmooth) {
    // A wave bent by 60 degrees along a line of the grid; the line is a border, others cross it.
    const Grid bent{12, 10, [](double i, double j) {
                        const double lift = j <= 5 ? 0 : (j - 5) * std::tan(std::numbers::pi / 3);
                        return Point(i, j, 0.3 * std::sin(0.5 * i) + lift);
                    }};
    const QuadMesh mesh = test::makeMesh(bent);
    const Layout layout =
        test::makeLayout(bent, {{0, 0, 5, 5}, {5, 0, 12, 5}, {0, 5, 12, 8}, {0, 8, 12, 10}});
    FitOptions options;
    options.watertight = true;
    const Surfaces surfaces = fitSurfaces(mesh, layout, dihedralAngles(mesh), options);
    expectInterpolates(mesh, layout, surfaces.patches);
    EXPECT_LT(surfaces.deviation.largestGapRelative, 1e-13);
    EXPECT_LT(surfaces.deviation.largestKink, 1e-5);
    EXPECT_LT(surfaces.deviation.max, 0.02) << "no overshoot beside the bend";
    const SurfacePoint below = evaluate(surfaces.patches[0], 2.5, 5);
    const SurfacePoint above = evaluate(surfaces.patches[2], 2.5, 0);
    EXPECT_NEAR(angleInDegrees(unitNormal(below.du, below.dv), unitNormal(above.du, above.dv)), 60, 2);
}

TEST(Fit, RefusesOptionsOutOfRange) {
    const QuadMesh mesh = test::makeMesh(sheet);
    const Layout layout = test::makeLayout(sheet, pinwheel);
    const std::vector<double> angles(mesh.n_edges(), 0.0);
    FitOptions options;
    options.rho = -1;
    EXPECT_THROW((void)fitSurfaces(mesh, layout, angles, options), Error);
    options = {};
    options.samplesPerEdge = 0;
    EXPECT_THROW((void)fitSurfaces(mesh, layout, angles, options), Error);
    options = {};
    options.fit = Fit::tolerance;
    for (const double bad : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
        options.tolerance.value = bad;
        EXPECT_THROW((void)fitSurfaces(mesh, layout, angles, options), Error);
    }
}

TEST(Fit, MakesFlatPatchesOfFourPoints) {
    const Grid flat{30, 20, [](double i, double j) { return Point(i, 2 * j, 0.5 * i); }};
    const QuadMesh mesh = test::makeMesh(flat);
    const Layout layout = test::makeLayout(
        flat,
        {{0, 0, 20, 8, 1}, {20, 0, 30, 14, 2}, {10, 14, 30, 20, 3}, {0, 8, 10, 20, 0}, {10, 8, 20, 14, 1}});
    FitOptions options;
    options.fit = Fit::tolerance;
    options.tolerance = {1e-7, true};
    const Surfaces surfaces = fitSurfaces(mesh, layout, dihedralAngles(mesh), options);
    EXPECT_EQ(controlPointCount(surfaces.patches), 5U * 4U);
    EXPECT_LT(surfaces.deviation.maxRelative, 1e-12);
    EXPECT_LT(surfaces.deviation.largestKink, 1e-6);
}

TEST(Fit, SlidesAlongTheMeshForFewerPoints) {
    // Flat, but its lines are up to a twentieth of an edge from where equal steps would put them.
    const Grid uneven{24, 16, [](double i, double j) {
                          return Point(i + 0.05 * std::sin(2.1 * i), j + 0.05 * std::cos(1.7 * j), 0);
                      }};
    const QuadMesh mesh = test::makeMesh(uneven);
    const Layout layout = test::makeLayout(uneven, {{0, 0, 14, 16}, {14, 0, 24, 16}});
    FitOptions options;
    options.fit = Fit::tolerance;
    options.tolerance = {1e-4, false};
    const Surfaces surfaces = fitSurfaces(mesh, layout, dihedralAngles(mesh), options);
    EXPECT_EQ(controlPointCount(surfaces.patches), 2U * 4U);
    EXPECT_LE(surfaces.deviation.max, 1e-4);
}

TEST(Fit, PutsKnotsWhereTheErrorIs) {
    const Grid bump{40, 10,
                    [](double i, double j) { return Point(i, j, 3 * std::exp(-(i - 9) * (i - 9) / 8)); }};
    const QuadMesh mesh = test::makeMesh(bump);
    const Layout layout = test::makeLayout(bump, {{0, 0, 40, 10}});
    FitOptions options;
    options.fit = Fit::tolerance;
    options.tolerance = {0.2, false};
    const Surfaces surfaces = fitSurfaces(mesh, layout, dihedralAngles(mesh), options);
    const Patch& patch = surfaces.patches[0];
    EXPECT_EQ(patch.degree[1], 1) << "nothing happens along v";
    EXPECT_EQ(patch.count[1], 2);
    int left = 0;
    for (const double knot : patch.knots[0])
        left += knot > 0 && knot < 20 ? 1 : 0;
    EXPECT_GT(2 * left, patch.count[0] - 4) << "most inner knots are at the bump";
}

TEST(CurveFit, PassesThroughFixedPointsAndKeepsTheTolerance) {
    CurveFitInput input;
    for (int k = 0; k <= 50; ++k)
        input.points.emplace_back(k, std::sin(0.3 * k), 0.05 * std::cos(7.0 * k));
    input.fixed = {7, 8, 31};
    input.startSlope = {1, 0.3, 0};
    input.endSlope = {1, 0, 0};
    for (const double tolerance : {1.0, 0.1, 0.01, 0.0001}) {
        const SplineCurve curve = fitCurve(input, tolerance, 1e-12);
        for (const int fixed : input.fixed)
            EXPECT_LT((evaluate(curve, fixed) - input.points[static_cast<std::size_t>(fixed)]).norm(), 1e-11);
        EXPECT_EQ(curve.points.front(), input.points.front());
        EXPECT_EQ(curve.points.back(), input.points.back());
        for (double t = 0; t < 50; t += 0.25) {
            const auto k = static_cast<std::size_t>(t);
            const double share = t - static_cast<double>(k);
            const Point onLine = (1 - share) * input.points[k] + share * input.points[k + 1];
            EXPECT_LE((evaluate(curve, t) - onLine).norm(), tolerance);
        }
    }
}

TEST(CurveFit, LowersTheDegreeWhereThatFits) {
    CurveFitInput input;
    for (int k = 0; k <= 10; ++k)
        input.points.emplace_back(k, 0.01 * k * k, 0);
    input.startSlope = {1, 0, 0};
    input.endSlope = {1, 0.2, 0};
    for (const auto& [tolerance, degree] : {std::pair(0.01, 2), std::pair(0.3, 1)}) {
        const SplineCurve cubic = fitCurve(input, tolerance, 1e-12);
        ASSERT_EQ(cubic.points.size(), 4U);
        const SplineCurve curve = withLeastDegree(input, tolerance, 1e-12, cubic, 1);
        EXPECT_EQ(curve.degree, degree);
        EXPECT_EQ(withLeastDegree(input, tolerance, 1e-12, cubic, 2).degree, 2);
        EXPECT_EQ(lowered(curve, degree).size(), static_cast<std::size_t>(degree) + 1);
        for (int k = 0; k <= 10; ++k)
            EXPECT_LE((evaluate(curve, k) - input.points[static_cast<std::size_t>(k)]).norm(), tolerance);
    }
}

TEST(CurveFit, IsCloserWhereItIsAsked) {
    CurveFitInput input;
    for (int k = 0; k <= 60; ++k)
        input.points.emplace_back(k, std::sin(0.5 * k), 0);
    input.closeness.assign(61, {});
    for (std::size_t k = 40; k <= 50; ++k)
        input.closeness[k] = {0.01, true};
    const SplineCurve curve = fitCurve(input, 0.5, 1e-12);
    const auto inner = [&](double begin, double end) {
        return std::ranges::count_if(curve.knots, [&](double knot) { return knot > begin && knot < end; });
    };
    for (int k = 40; k <= 50; ++k)
        EXPECT_LT(std::abs(evaluate(curve, k)[1] - input.points[static_cast<std::size_t>(k)][1]), 0.01);
    EXPECT_GT(inner(39, 51), inner(0, 39)) << "and nowhere else";
}

TEST(Closeness, GrowsFromShareToNoSlidingToAWiderCircle) {
    const QuadMesh mesh = test::makeMesh(sheet);
    const Layout layout = test::makeLayout(sheet, {{0, 0, 16, 12}});
    std::vector<Closeness> closeness(mesh.n_vertices());
    const std::vector<std::vector<DeviatingPlace>> places = {{{{5.5, 4}, 1.25}}};
    const auto count = [&](const auto& is) { return std::ranges::count_if(closeness, is); };
    const auto slides = [](const Closeness& c) { return c.slides; };
    const auto all = static_cast<std::ptrdiff_t>(closeness.size());
    comeCloser(mesh, layout, places, 1, closeness);
    EXPECT_EQ(count([](const Closeness& c) { return std::abs(c.share - 0.96 / 1.25) < 1e-12; }), 2);
    EXPECT_EQ(count(slides), all);
    comeCloser(mesh, layout, places, 1, closeness);
    EXPECT_EQ(count(slides), all - 2);
    comeCloser(mesh, layout, places, 1, closeness);
    EXPECT_EQ(count(slides), all - 12);
}

TEST(CurveFit, FollowsACornerWithATripleKnot) {
    CurveFitInput input;
    for (int k = 0; k <= 20; ++k)
        input.points.emplace_back(k, std::abs(k - 13), 0);
    input.startSlope = {1, -1, 0};
    input.endSlope = {1, 1, 0};
    const SplineCurve curve = fitCurve(input, 1e-9, 1e-12);
    EXPECT_EQ(std::count(curve.knots.begin(), curve.knots.end(), 13.0), 3);
}

TEST(KnotRefinement, SplitsAtTheCentreOfTheErrorsAndRaisesUnitIntervals) {
    KnotRefinement refinement({0, 0, 0, 0, 1, 9, 9, 9, 9}, {});
    refinement.addError(6.5, 2);
    refinement.addError(7.5, 2);
    refinement.addError(0.5, 1);
    EXPECT_EQ(refinement.refined(), (std::vector<double>{0, 0, 0, 0, 1, 1, 7, 9, 9, 9, 9}));
    EXPECT_FALSE(KnotRefinement({0, 0, 0, 0, 1, 1, 1, 9, 9, 9, 9}, {}).canRefine(0.5));
}

TEST(KnotRefinement, HalvesUnitIntervalsButAtSharpPlaces) {
    const KnotRules rules{0.25, false, {false, false, false, true, false}};
    KnotRefinement refinement({0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4}, rules);
    refinement.addError(1.5, 1);
    refinement.addError(2.6, 1);
    EXPECT_EQ(refinement.refined(), (std::vector<double>{0, 0, 0, 0, 1, 1.5, 2, 3, 3, 4, 4, 4, 4}));
    EXPECT_FALSE(KnotRefinement({0, 0, 0, 0, 0.25, 4, 4, 4, 4}, rules).canRefine(0.1));
}

TEST(Fit, EndsOnDegenerateGeometry) {
    const auto step = [](double i, double j) { return Point(std::min(i, 4.0), j < 3 ? 0 : j, 0); };
    for (const auto& place : std::vector<std::function<Point(double, double)>>{
             [](double, double) { return Point(1, 2, 3); },                     // everything at one place
             [](double i, double) { return Point(i, 0, 0); },                   // squeezed to a line
             step,                                                              // many vertices at one place
             [](double i, double j) { return Point(1e-9 * i, 1e9 * j, i * j); } // steps of any length
         }) {
        const Grid grid{9, 7, place};
        const QuadMesh mesh = test::makeMesh(grid);
        const Layout layout =
            test::makeLayout(grid, {{0, 0, 6, 3}, {6, 0, 9, 5}, {4, 5, 9, 7}, {0, 3, 4, 7}, {4, 3, 6, 5}});
        for (const bool watertight : {false, true}) {
            FitOptions options;
            options.watertight = watertight;
            expectInterpolates(mesh, layout,
                               fitSurfaces(mesh, layout, dihedralAngles(mesh), options).patches);
        }
        FitOptions options;
        options.fit = Fit::tolerance;
        const Surfaces surfaces = fitSurfaces(mesh, layout, dihedralAngles(mesh), options);
        EXPECT_LE(surfaces.deviation.max, 0.001 * boundingBoxDiagonal(mesh) + 1e-12);
    }
}

TEST(Fit, TakesAnEmptyMesh) {
    const Surfaces surfaces = fitSurfaces(QuadMesh(), Layout(), {}, {});
    EXPECT_TRUE(surfaces.patches.empty());
    EXPECT_EQ(surfaces.deviation.max, 0);
}

} // namespace
} // namespace qm
