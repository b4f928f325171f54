#include "base/at.h"
#include "bspline/measure/box_pieces.h"
#include "bspline/measure/certified_deviation.h"
#include "bspline/measure/folds.h"
#include "bspline/measure/foot_search.h"
#include "bspline/splines/interpolate.h"
#include "support/grid_layout.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace qm {
namespace {

using test::Grid;

/// A patch through points of a smooth shape, and the shape itself.
struct Pair {
    Grid grid;
    std::vector<test::Rectangle> rectangles;
    std::function<Point(double, double)> shape;
    int steps = 4;

    QuadMesh mesh = test::makeMesh(grid);
    Layout layout = test::makeLayout(grid, rectangles);
    std::vector<Patch> patches = interpolateSegments(mesh, layout, 1);
    std::vector<BorderEdge> borders = borderEdges(mesh, layout);
    std::vector<ReferenceGrid> references = makeReferences();

    [[nodiscard]] std::vector<ReferenceGrid> makeReferences() const {
        std::vector<ReferenceGrid> result;
        for (const test::Rectangle& r : rectangles) {
            ReferenceGrid reference{{r.i1 - r.i0, r.j1 - r.j0}, steps};
            if (r.turned % 2 == 1) std::swap(reference.size[0], reference.size[1]);
            for (int j = 0; j <= reference.size[1] * steps; ++j)
                for (int i = 0; i <= reference.size[0] * steps; ++i) {
                    const double u = static_cast<double>(i) / steps;
                    const double v = static_cast<double>(j) / steps;
                    const double width = r.i1 - r.i0;
                    const double height = r.j1 - r.j0;
                    const std::array<std::array<double, 2>, 4> places{
                        {{u, v}, {width - v, u}, {width - u, height - v}, {v, height - u}}};
                    const auto& [column, row] = places[at(r.turned)];
                    reference.points.push_back(shape(r.i0 + column, r.j0 + row));
                }
            result.push_back(reference);
        }
        return result;
    }

    [[nodiscard]] PairedSurfaces paired() const { return {layout, patches, references, borders, 1}; }
};

/// The largest distance from one surface to the other, measured at many points by a search from their
/// parameters.
double sampledMaximum(const PairedSurfaces& surfaces, std::size_t patch, int perEdge) {
    FootSearch search(surfaces);
    const auto extent = surfaces.extent(patch);
    double largest = 0;
    BezierPiece piece;
    for (std::size_t surface : {0U, 1U})
        for (int j = 0; j <= extent[1] * perEdge; ++j)
            for (int i = 0; i <= extent[0] * perEdge; ++i) {
                const LayoutPlace place{patch, {1.0 * i / perEdge, 1.0 * j / perEdge}};
                const Cell cell = surfaces.cellAt(place);
                surfaces.get(surface, cell, piece);
                const auto [us, vs] = surfaces.box(cell);
                const auto at = evaluate(piece, (place.at[0] - us[0]) / (us[1] - us[0]),
                                         (place.at[1] - vs[0]) / (vs[1] - vs[0]));
                largest = std::max(largest, search(1 - surface, place, at.position).distance);
            }
    return largest;
}

const auto wave = [](double i, double j) { return Point(i, j, std::sin(0.7 * i) * std::cos(0.5 * j)); };

TEST(CertifiedDeviation, ClosesAroundTheTrueMaximum) {
    const Pair pair{{12, 9, wave}, {{0, 0, 12, 4}, {0, 4, 5, 9, 1}, {5, 4, 12, 9, 3}}, wave};
    const PairedSurfaces surfaces = pair.paired();
    for (std::size_t patch = 0; patch < surfaces.patches(); ++patch) {
        const auto deviation = certifiedDeviation(surfaces, patch, {});
        const double sampled = sampledMaximum(surfaces, patch, 40);
        EXPECT_GE(deviation.upper, sampled);
        EXPECT_LE(deviation.upper, 1.021 * deviation.lower);
        EXPECT_LE(deviation.lower, 1.01 * sampled);
        EXPECT_LT(rootMeanSquare(deviation.samples), deviation.upper);
        EXPECT_GT(rootMeanSquare(deviation.samples), 0);
    }
}

TEST(CertifiedDeviation, IsNotMisledBySlidingParameters) {
    // A cylinder whose points are shifted along it, with the same and with a slightly larger radius.
    for (const double lift : {0.0, 0.01}) {
        const auto tube = [&](double radius, double shift) {
            return [=](double i, double j) {
                const double angle = 0.1 * (i + shift * std::sin(0.4 * i) * (1 + 0.05 * j));
                return Point(radius * std::cos(angle), j, radius * std::sin(angle));
            };
        };
        const auto moved = tube(10 + lift, 0.1);
        const Pair pair{{16, 6, tube(10, 0)}, {{0, 0, 8, 6}, {8, 0, 16, 6, 2}}, moved};
        const PairedSurfaces surfaces = pair.paired();
        // At the border of the patches, i = 8, equal parameters do not give equal points.
        const auto deviation = certifiedDeviation(surfaces, 0, {.effort = 200});
        const double sampled = sampledMaximum(surfaces, 0, 40);
        EXPECT_GE(deviation.upper, 0.999999 * sampled);
        EXPECT_LE(deviation.upper, 1.021 * deviation.lower) << lift;
        EXPECT_LT(rootMeanSquare(deviation.samples), 0.02 + lift);
    }
}

TEST(CertifiedDeviation, LooksLittleAtPlanesHoweverTheirParametersRun) {
    const auto plane = [](double i, double j) { return Point(i, j, 2); };
    const auto twisted = [](double i, double j) {
        constexpr double waves = std::numbers::pi / 4; // zero on the border
        return Point(i + 0.3 * std::sin(waves * i) * std::cos(0.8 * j),
                     j + 0.3 * std::sin(waves * j) * std::sin(0.9 * i), 2);
    };
    const auto lifted = [&](double i, double j) { return twisted(i, j) + Point(0, 0, 0.001 * (1 + i / 8)); };
    const std::vector<test::Rectangle> one{{0, 0, 8, 8}};
    const Pair level{{8, 8, plane}, one, twisted};
    EXPECT_LT(certifiedDeviation(level.paired(), 0, {.negligible = 0.01, .effort = 1}).upper, 0.01);
    const Pair tilted{{8, 8, plane}, one, lifted};
    const auto deviation = certifiedDeviation(tilted.paired(), 0, {.negligible = 0.0021, .effort = 30});
    EXPECT_GE(deviation.upper, 0.00199);
    EXPECT_LE(deviation.upper, 0.0021);
}

TEST(CertifiedDeviation, ClosesWhereBordersSlideInAPlane) {
    const auto plane = [](double i, double j) { return Point(i, j, 2); };
    const auto slid = [](double i, double j) {
        constexpr double waves = std::numbers::pi / 8; // zero on the boundary
        return Point(i + 0.3 * std::sin(waves * i) * std::cos(0.8 * j), j, 2);
    };
    for (int turns = 0; turns < 4; ++turns) {
        const Pair pair{{8, 8, plane}, {{0, 0, 4, 8}, {4, 0, 8, 8, turns}}, slid};
        const PairedSurfaces surfaces = pair.paired();
        for (std::size_t patch : {0U, 1U})
            EXPECT_LE(certifiedDeviation(surfaces, patch, {.negligible = 1e-5}).upper, 1e-5) << turns;
    }
}

TEST(BoxPieces, ContinueInTheNeighbourWhateverItsDirectionsAre) {
    const ParameterBox box{{{3.5, 4.5}, {2, 3.25}}};
    for (int turns = 0; turns < 4; ++turns) {
        const Pair pair{{8, 6, wave}, {{0, 0, 4, 6}, {4, 0, 8, 6, turns}}, wave};
        const PairedSurfaces surfaces = pair.paired();
        int corners = 0;
        double area = 0;
        ASSERT_TRUE(BoxPieces(surfaces).visit(1, 0, box, [&](const BoxPiece& part) {
            area += part.width[0] * part.width[1];
            const int degree = part.piece.degree[0];
            for (const std::size_t i : {0U, 1U})
                for (const std::size_t j : {0U, 1U}) {
                    if (!part.isAtEnd[0][i] || !part.isAtEnd[1][j]) continue;
                    ++corners;
                    const Point expected = wave(box[0][i], box[1][j]);
                    const Eigen::Vector3d& found = part.piece.at(i == 0 ? 0 : degree, j == 0 ? 0 : degree);
                    for (unsigned k = 0; k < 3; ++k)
                        EXPECT_NEAR(found[k], expected[k], 1e-9) << turns;
                }
        }));
        EXPECT_EQ(corners, 4);
        EXPECT_NEAR(area, 1.25, 1e-9);
    }
}

TEST(BoxPieces, EndWhereTwoNeighboursLieBeyondASide) {
    const auto plane = [](double i, double j) { return Point(i, j, 0); };
    Pair pair{{8, 6, plane}, {{0, 0, 4, 6}, {4, 0, 8, 3}, {4, 3, 8, 6}}, plane};
    for (std::size_t p = 0; p < 3; ++p) { // the patches meet with equal parameters
        Patch& patch = pair.patches[p];
        const auto& corner = pair.rectangles[p];
        for (int k = 0; k < std::ssize(patch.controlPoints); ++k)
            patch.controlPoints[at(k)] =
                Point(corner.i0 + k % patch.count[0] - 1, corner.j0 + k / patch.count[0] - 1, 0);
    }
    const auto parts = [&](double from, double to) {
        return boxParts(pair.paired(), 0, {{{3.5, 4.5}, {from, to}}});
    };
    EXPECT_EQ(parts(2, 3).size(), 2);
    ASSERT_EQ(parts(2.5, 3.5).size(), 1);
    EXPECT_EQ(parts(2.5, 3.5)[0].box[0][1], 4);
    EXPECT_TRUE(parts(2.5, 3.5)[0].isAtEnd[0][1]);
    for (Point& point : pair.patches[1].controlPoints)
        point[2] = 0.01;
    EXPECT_EQ(parts(2, 3).size(), 1) << "there is a gap between them";
}

TEST(CertifiedDeviation, SeesGapsBetweenPatches) {
    const auto plane = [](double i, double j) { return Point(i, j, 0); };
    Pair pair{{8, 6, plane}, {{0, 0, 4, 6}, {4, 0, 8, 6}}, plane};
    EXPECT_LT(certifiedDeviation(pair.paired(), 1, {}).upper, 1e-6);
    // The second patch begins at 4.02 in the place of 4: all points lie in the plane, but the reference
    // between is up to 0.01 away from both patches.
    for (Point& point : pair.patches[1].controlPoints)
        point[0] = 8 - 0.995 * (8 - point[0]);
    const auto deviation = certifiedDeviation(pair.paired(), 1, {.effort = 200});
    EXPECT_GE(deviation.upper, 0.01 - 1e-9);
    EXPECT_LT(deviation.upper, 0.0201);
}

TEST(CertifiedDeviation, IsAboveAllSamples) {
    // A surface that lies on its reference, but with points that slide along the bend, where distances to
    // first order are too large.
    const auto bend = [](double shift) {
        return [=](double i, double j) {
            const double unit = std::numbers::pi / 48;
            const double x = unit * (i + shift * std::sin(unit * i));
            return Point(x, unit * j, std::sin(x));
        };
    };
    const Pair pair{{96, 4, bend(0)}, {{0, 0, 96, 4}}, bend(0.08)};
    const auto deviation = certifiedDeviation(pair.paired(), 0, {.effort = 200});
    for (const auto& [distance, area] : deviation.samples)
        EXPECT_LE(distance, deviation.upper);
    EXPECT_LE(percentile95(deviation.samples), deviation.upper);
    EXPECT_LE(rootMeanSquare(deviation.samples), deviation.upper);
}

TEST(CertifiedDeviation, Percentile95IsByArea) {
    EXPECT_EQ(percentile95({}), 0);
    EXPECT_EQ(percentile95({{3, 0}}), 0);
    EXPECT_EQ(percentile95({{3, 2}}), 3);
    EXPECT_EQ(percentile95({{1, 90}, {5, 4}, {2, 6}}), 2);
    EXPECT_EQ(percentile95({{1, 90}, {5, 6}, {2, 4}}), 5);
    Samples even;
    for (int k = 0; k < 1000; ++k)
        even.push_back({static_cast<double>((k * 37) % 1000)});
    EXPECT_EQ(percentile95(even), 949);
}

TEST(CertifiedDeviation, FindsASpikeBetweenSamples) {
    // A double step between grid lines, which samples at half edges do not see.
    Pair pair{{8, 8, wave}, {{0, 0, 8, 8}}, wave};
    Patch& patch = pair.patches[0];
    const auto before = certifiedDeviation(pair.paired(), 0, {});
    patch.controlPoints[5 * 11 + 5] += Point(0, 0, 0.5);
    const auto after = certifiedDeviation(pair.paired(), 0, {});
    EXPECT_LT(before.upper, 0.1);
    EXPECT_NEAR(after.lower, 0.5 * 4 / 9, 0.1);
    EXPECT_NEAR(after.place.at[0], 4, 0.3);
    EXPECT_NEAR(after.place.at[1], 4, 0.3);
}

TEST(CertifiedDeviation, OfEqualSurfacesIsNothing) {
    const auto plane = [](double i, double j) { return Point(i, j, 0); };
    Pair pair{{6, 6, plane}, {{0, 0, 6, 6}}, plane};
    for (int k = 0; k < 81; ++k)
        pair.patches[0].controlPoints[at(k)] = Point(k % 9 - 1, k / 9 - 1, 0);
    const auto deviation = certifiedDeviation(pair.paired(), 0, {.negligible = 1e-12});
    EXPECT_LT(deviation.upper, 1e-12);
}

TEST(Folds, AreFoundWhereTheNormalTurnsOver) {
    const auto plane = [](double i, double j) { return Point(i, j, 0.1 * i * j); };
    Pair pair{{6, 6, plane}, {{0, 0, 6, 6}}, plane};
    EXPECT_TRUE(findFolds(pair.patches[0], pair.references[0]).empty());
    Patch& patch = pair.patches[0];
    patch.controlPoints[4 * 9 + 4] += Point(4, 0, 0);
    const auto folds = findFolds(patch, pair.references[0]);
    ASSERT_FALSE(folds.empty());
    for (const auto& fold : folds) {
        EXPECT_NEAR(fold[0], 3, 2);
        EXPECT_NEAR(fold[1], 3, 2);
    }
}

TEST(Folds, AreNotSeenWhereOnlyTheReferenceTurnsOver) {
    const auto plane = [](double i, double j) { return Point(i, j, 0.1 * i * j); };
    Pair pair{{6, 6, plane}, {{0, 0, 6, 6}}, plane};
    ReferenceGrid& reference = pair.references[0];
    for (int j = 9; j < 12; ++j) // inside a quad: the reference turns back and forward again
        for (const int i : {9, 11})
            reference.points[at(j * 25 + i)] += Point(i == 9 ? 0.7 : -0.7, 0, 0);
    const SurfacePoint there = reference.evaluate(2.5, 2.5);
    ASSERT_LT((there.du % there.dv)[2], 0);
    EXPECT_TRUE(findFolds(pair.patches[0], reference).empty());
    pair.patches[0].controlPoints[4 * 9 + 4] += Point(4, 0, 0);
    EXPECT_FALSE(findFolds(pair.patches[0], reference).empty());
}

TEST(Folds, AreNotSeenInStronglyBentPatches) {
    const auto roll = [](double i, double j) { return Point(std::cos(0.3 * i), j, std::sin(0.3 * i)); };
    const Pair pair{{20, 3, roll}, {{0, 0, 20, 3}}, roll};
    EXPECT_TRUE(findFolds(pair.patches[0], pair.references[0]).empty());
}

TEST(FootSearch, FindsWideQuadsFromNarrowOnes) {
    // Beyond line 4 quads are narrow: a step measured in them leads far beyond what is nearest.
    const auto uneven = [](double i, double j) { return Point(i < 4 ? 100 * (i - 4) : i - 4, j, 0); };
    const Pair pair{{8, 4, uneven}, {{0, 0, 8, 4}}, uneven, 1};
    const PairedSurfaces surfaces = pair.paired();
    FootSearch search(surfaces);
    for (const double x : {-0.3, -2.0, -40.0, 1.5})
        for (const double from : {4.02, 4.6, 6.0}) {
            const Foot foot = search(1, {0, {from, 2.1}}, {x, 1.7, 0.5});
            EXPECT_NEAR(foot.distance, 0.5, 1e-9) << x << " from " << from;
        }
}

TEST(FootSearch, ComesBackOverACreaseThatAStepWentBeyond) {
    // Columns from 2 on lie flat and slow down; those before stand upright.
    const auto shape = [](double i, double j) {
        const double s = i - 2;
        return s < 0 ? Point(0, j, s) : Point(2 * s - s * s / 2, j, 0);
    };
    const Pair pair{{4, 4, shape}, {{0, 0, 2, 4}, {2, 0, 4, 4}}, shape};
    const PairedSurfaces surfaces = pair.paired();
    FootSearch search(surfaces);
    for (const double x : {0.001, 0.05, 0.2})
        EXPECT_NEAR(search(1, {1, {0.9, 2}}, {x, 1.9, 0}).distance, 0, 1e-6) << x;
}

} // namespace
} // namespace qm
