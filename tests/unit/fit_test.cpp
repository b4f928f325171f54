#include "bspline/chains.h"
#include "bspline/evaluate.h"
#include "bspline/fit.h"
#include "base/error.h"
#include "mesh/dihedral.h"
#include "support/grid_layout.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace qm {
namespace {

using test::Grid;
using test::Rectangle;

Point wavy(double i, double j) { return {i + 0.2 * std::sin(j), j, std::sin(0.4 * i) * std::cos(0.3 * j)}; }

const Grid sheet{16, 12, wavy};
// A pinwheel: four chains that end on one another in a circle, around a fifth patch; turned in every way.
const std::vector<Rectangle> pinwheel = {
    {0, 0, 10, 4, 1}, {10, 0, 16, 8, 2}, {6, 8, 16, 12, 3}, {0, 4, 6, 12, 0}, {6, 4, 10, 8, 1}};

Grid tube() {
    return {24, 10,
            [](double i, double j) {
                const double angle = i * std::numbers::pi / 12;
                return Point((3 + 0.3 * std::sin(j)) * std::cos(angle), (3 + 0.3 * std::sin(j)) * std::sin(angle), j);
            },
            true};
}
// Two rings, one split once, the other twice elsewhere.
const std::vector<Rectangle> rings = {{0, 0, 24, 4, 0}, {5, 4, 15, 10, 2}, {15, 4, 29, 10, 3}};

struct Case {
    const char *name;
    Grid grid;
    std::vector<Rectangle> rectangles;
};

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

void expectInterpolates(const QuadMesh &mesh, const Layout &layout, const std::vector<Patch> &patches) {
    for (std::size_t s = 0; s < patches.size(); ++s) {
        const auto vertices = vertexGrid(mesh, layout.segments[s]);
        const auto [a, b] = layout.segments[s].size;
        EXPECT_EQ(patches[s].segment, SegmentId(s));
        EXPECT_EQ(domain(patches[s])[0], (std::array<double, 2>{0, static_cast<double>(a)}));
        for (int j = 0; j <= b; ++j)
            for (int i = 0; i <= a; ++i) {
                const Point expected = mesh.point(vertices[static_cast<std::size_t>(j * (a + 1) + i)]);
                EXPECT_LT((evaluate(patches[s], i, j).position - expected).norm(), 1e-11) << s << ": " << i << ' ' << j;
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
    EXPECT_GT(plain.deviation.largestKink, 1);
    EXPECT_LT(surfaces.deviation.max, 1.05 * plain.deviation.max);
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

INSTANTIATE_TEST_SUITE_P(Cases, FitLayouts,
                         testing::Values(Case{"pinwheel", sheet, pinwheel}, Case{"rings", tube(), rings},
                                         Case{"whole", sheet, {{0, 0, 16, 12, 0}}},
                                         Case{"smallest", {4, 2, wavy}, {{0, 0, 1, 1}, {1, 0, 4, 1, 1}, {0, 1, 2, 2, 3}, {2, 1, 4, 2, 2}}}),
                         [](const auto &instance) { return instance.param.name; });

TEST(Chains, RunPastTJointsAndEndOnOthers) {
    const QuadMesh mesh = test::makeMesh(sheet);
    const Layout layout = test::makeLayout(sheet, pinwheel);
    const Chains chains(mesh, layout);
    std::size_t edges = 0;
    std::size_t inner = 0;
    for (const Chain &chain : chains.all()) {
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
            const SidePiece &piece = chains.pieces(s, side).front();
            const auto &vertices = layout.segments[s].sides[static_cast<std::size_t>(side)];
            EXPECT_EQ(piece.length + 1, static_cast<int>(vertices.size()));
            EXPECT_EQ(mesh.from_vertex_handle(chains.halfedge(piece.place)), vertices.front());
        }
}

TEST(Chains, KnowClosedOnes) {
    const Grid grid = tube();
    const QuadMesh mesh = test::makeMesh(grid);
    const Chains chains(mesh, test::makeLayout(grid, rings));
    int closed = 0;
    for (const Chain &chain : chains.all())
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
    const Layout layout = test::makeLayout(bent, {{0, 0, 5, 5}, {5, 0, 12, 5}, {0, 5, 12, 8}, {0, 8, 12, 10}});
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
}

TEST(Fit, TakesAnEmptyMesh) {
    const Surfaces surfaces = fitSurfaces(QuadMesh(), Layout(), {}, {});
    EXPECT_TRUE(surfaces.patches.empty());
    EXPECT_EQ(surfaces.deviation.max, 0);
}

} // namespace
} // namespace qm
