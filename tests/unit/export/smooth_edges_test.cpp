/// \file Edges of STEP files are smooth or sharp.
#include "export/boundary/shared_edges.h"
#include "support/exported_shape.h"

#include <gtest/gtest.h>

#include <BRep_Tool.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shape.hxx>
#include <cmath>
#include <vector>

namespace qm {
namespace {

using test::all;
using test::countSmoothEdges;
using test::fitted;
using test::FittedModel;
using test::Grid;
using test::readBack;

TEST(Edges, AreFoundSmoothByTheReader) {
    // A roof with a sharp ridge, and a seam without any bend.
    const Grid grid{8, 4, [](double i, double j) { return Point(i, j, 0.1 * i * i - std::abs(j - 2)); }};
    const FittedModel model = fitted(grid, {{0, 0, 8, 2}, {0, 2, 3, 4}, {3, 2, 8, 4}}, FitOptions());
    const ShapeReport report = *exportModel(model.mesh, model.layout, &model.surfaces, {}).shape;
    const TopoDS_Shape shape = readBack(model);
    EXPECT_GT(report.smoothEdges, 0U);
    EXPECT_EQ(countSmoothEdges(shape), static_cast<int>(report.smoothEdges));
    for (const TopoDS_Shape& edge : all(shape, TopAbs_EDGE))
        EXPECT_LE(BRep_Tool::Tolerance(TopoDS::Edge(edge)), 1.0001e-7);
}

TEST(Edges, AreSmoothOrSharpNeverBoth) {
    // A roof whose ridge begins halfway along the border of its two faces.
    const Grid grid{8, 4, [](double i, double j) { return Point(i, j, i < 4 ? 0.0 : -2 * std::abs(j - 2)); }};
    const FittedModel model = fitted(grid, {{0, 0, 8, 2}, {0, 2, 8, 4}}, FitOptions());
    const SharedEdges shared = shareEdges(model.mesh, model.layout, model.surfaces.patches);
    std::vector<int> smooth;
    std::vector<int> sharp;
    for (const SharedEdge& edge : shared.edges)
        if (edge.places.size() == 2) (edge.angle < 0.01 ? smooth : sharp).push_back(edge.length);
    EXPECT_EQ(smooth, std::vector{3}) << "the first quads that bend are those before vertex 4";
    EXPECT_EQ(sharp, std::vector{5});
    EXPECT_EQ(countSmoothEdges(readBack(model)), 1);
}

} // namespace
} // namespace qm
