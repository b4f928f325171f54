// Simple surfaces of many patches, and what stays smooth between them.
#include "export/export.h"
#include "export/simple/smooth_borders.h"
#include "support/fitted_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace qm {
namespace {

using test::fitted;
using test::FittedModel;
using test::Grid;

/// Squares of 8 x 8 quads.
std::vector<test::Rectangle> squares(int columns, int rows) {
    constexpr int size = 8;
    std::vector<test::Rectangle> result;
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i)
            result.push_back({size * i, size * j, size * (i + 1), size * (j + 1)});
    return result;
}

FittedModel sheetOf(int columns, int rows, const std::function<Point(double, double)>& pointAt) {
    FitOptions options;
    options.tolerance.value = 0.005;
    return fitted(Grid{8 * columns, 8 * rows, pointAt}, squares(columns, rows), options);
}

/// On a surface around an axis, 0.08 radians and 0.25 up for every quad.
FittedModel revolved(int columns, int rows, const std::function<double(double)>& radius) {
    return sheetOf(columns, rows, [radius](double i, double j) {
        const double away = radius(0.25 * j);
        return Point(away * std::cos(0.08 * i), away * std::sin(0.08 * i), 0.25 * j);
    });
}

Exported exported(const FittedModel& model, double percent, bool join = true) {
    ExportOptions options;
    options.analytic = true;
    options.join = join;
    options.analyticTolerance = {percent, true};
    return exportModel(model.mesh, model.layout, &model.surfaces, options);
}

std::size_t count(const Exported& file, const std::string& entity) {
    std::size_t result = 0;
    for (std::size_t at = file.bytes.find(entity + "("); at != std::string::npos;
         at = file.bytes.find(entity + "(", at + 1))
        ++result;
    return result;
}

TEST(AnalyticRegions, PatchesAreWhatTheyAreTogether) {
    const FittedModel sphere =
        revolved(4, 3, [](double z) { return std::sqrt(25 - (z - 3) * (z - 3)); }); // of radius 5
    for (const double percent : {0.3, 2.0}) { // every patch alone is a cylinder within the larger one
        const Exported file = exported(sphere, percent, false);
        EXPECT_EQ(count(file, "SPHERICAL_SURFACE"), 12U) << percent;
        EXPECT_EQ(file.shape->faces, 12U);
        EXPECT_LT(file.shape->largestNewAngle, 0.01);
    }
}

TEST(AnalyticRegions, SmoothEdgesStaySmooth) {
    // A cylinder that opens smoothly; what follows is nothing simple.
    const FittedModel vase = revolved(3, 3, [](double z) {
        const double above = std::max(0.0, z - 2);
        return 3 + 0.1 * above * above * (1 + 0.3 * std::sin(2 * above));
    });
    for (const double percent : {0.3, 1.0, 3.0}) {
        const Exported file = exported(vase, percent);
        EXPECT_LT(file.shape->largestNewAngle, 1.1 * maxNewAngle) << percent;
        EXPECT_TRUE(file.shape->valid);
    }
}

TEST(AnalyticRegions, WavyPatchesLieInThePlaneOfTheirNeighbours) {
    const FittedModel flat = sheetOf(3, 3, [](double i, double j) {
        const double x = (i - 12) / 4;
        const double y = (j - 12) / 4;
        const bool isInMiddle = std::abs(x) < 1 && std::abs(y) < 1;
        return Point(i, j, isInMiddle ? 0.02 * std::pow((1 - x * x) * (1 - y * y), 2) * (2 + x) : 0);
    });
    const Exported file = exported(flat, 0.5);
    EXPECT_EQ(count(file, "PLANE"), 1U);
    EXPECT_EQ(file.shape->faces, 1U);
}

TEST(MergePlanes, LeavesOutOnlyWhatIsTurnedOver) {
    const auto isTurned = [](double i) { return i >= 4 && i <= 6; };
    std::vector<test::Rectangle> small;
    for (int j = 0; j < 10; j += 2)
        for (int i = 0; i < 10; i += 2)
            small.push_back({i, j, i + 2, j + 2});
    const FittedModel model = fitted(Grid{10, 10,
                                          [&](double i, double j) {
                                              const bool turned = isTurned(i) && isTurned(j);
                                              return Point(turned ? 5 + 0.6 * (5 - i) : i, j, 0);
                                          }},
                                     small, FitOptions());
    ExportOptions options;
    EXPECT_EQ(exportModel(model.mesh, model.layout, &model.surfaces, options).shape->faces, 25U);
    options.join = true;
    const ShapeReport joined = *exportModel(model.mesh, model.layout, &model.surfaces, options).shape;
    EXPECT_LE(joined.faces, 6U) << "and not 13";
}

/// A plane and one tilted against it, both to the side of a border along x.
TEST(KeepSmooth, TheSurfaceWithLessWeightGivesWay) {
    const auto plane = [](double degrees, double weight, bool mayGo) {
        const double angle = degrees / 180 * 3.14159265358979;
        return PlacedShape{
            {SimpleKind::plane, {0, 0, 0}, {0, std::sin(angle), std::cos(angle)}}, 1, weight, mayGo};
    };
    const std::vector<Eigen::Vector3d> up(2, {0, 0, 1});
    const std::vector<SmoothBorder> borders{{{0, 1}, {{0, 0, 0}, {1, 0, 0}}, {up, up}},
                                            {{1, 2}, {{0, 0, 0}, {1, 0, 0}}, {up, up}}};
    std::vector<std::optional<PlacedShape>> shapes{plane(0.8, 5, true), plane(0, 2, true),
                                                   plane(-0.8, 1, true)};
    keepSmooth(borders, shapes);
    EXPECT_TRUE(shapes[0] && shapes[1] && shapes[2]) << "bent by less than a degree";
    shapes[2] = plane(-2, 1, true);
    keepSmooth(borders, shapes);
    EXPECT_TRUE(shapes[0] && shapes[1] && !shapes[2]);
    shapes[2] = plane(-2, 0, false);
    keepSmooth(borders, shapes);
    EXPECT_TRUE(shapes[0] && !shapes[1] && shapes[2]) << "the last is a plane exactly";
    shapes = {plane(2, 5, true), std::nullopt, std::nullopt};
    keepSmooth(borders, shapes);
    EXPECT_FALSE(shapes[0]) << "its neighbour stays";
}

} // namespace
} // namespace qm
