#include "support/exported_shape.h"

#include <gtest/gtest.h>

#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <STEPControl_Reader.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shape.hxx>
#include <cmath>
#include <functional>
#include <numbers>
#include <sstream>
#include <vector>

namespace qm::test {

TopoDS_Shape readStep(const std::string& text) {
    STEPControl_Reader reader;
    std::istringstream stream(text);
    EXPECT_EQ(reader.ReadStream("shape.step", stream), IFSelect_RetDone);
    EXPECT_GT(reader.TransferRoots(), 0);
    return reader.OneShape();
}

TopoDS_Shape readBack(const FittedModel& model, const ExportOptions& options) {
    TopoDS_Shape shape = readStep(exportModel(model.mesh, model.layout, &model.surfaces, options).bytes);
    EXPECT_TRUE(BRepCheck_Analyzer(shape).IsValid());
    return shape;
}

std::vector<TopoDS_Shape> all(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
    TopTools_IndexedMapOfShape found;
    TopExp::MapShapes(shape, kind, found);
    std::vector<TopoDS_Shape> result;
    for (int k = 1; k <= found.Extent(); ++k)
        result.push_back(found(k));
    return result;
}

int countSmoothEdges(const TopoDS_Shape& shape) {
    int count = 0;
    for (const TopoDS_Shape& edge : all(shape, TopAbs_EDGE))
        if (BRep_Tool::MaxContinuity(TopoDS::Edge(edge)) >= GeomAbs_G1) ++count;
    return count;
}

double area(const TopoDS_Shape& shape) {
    GProp_GProps properties;
    BRepGProp::SurfaceProperties(shape, properties);
    return properties.Mass();
}

ExportOptions joining() {
    ExportOptions options;
    options.join = true;
    return options;
}

ExportOptions analytic() {
    ExportOptions options;
    options.analytic = true;
    options.analyticTolerance = {0.1, true};
    return options;
}

ExportOptions joiningAnalytic() {
    ExportOptions options = analytic();
    options.join = true;
    return options;
}

FittedModel revolved(const std::function<double(double)>& radius, bool inwards,
                     const std::vector<Rectangle>& rectangles) {
    const Grid grid{rectangles.back().i1, 16, [&](double i, double j) {
                        const double angle = (inwards ? -1 : 1) * 0.06 * i;
                        const double away = radius(0.2 * j);
                        return Point(7 + away * std::cos(angle), 0.2 * j - 3, away * std::sin(angle));
                    }};
    FitOptions options;
    options.tolerance.value = 0.01;
    return fitted(grid, rectangles, options);
}

std::vector<Rectangle> pinwheel(int from, int to) {
    const int third = (to - from) / 3;
    return {{from, 0, to - third, 6},
            {to - third, 0, to, 10},
            {from + third, 10, to, 16},
            {from, 6, from + third, 16},
            {from + third, 6, to - third, 10}};
}

FittedModel tube(double bump) {
    auto rectangles = pinwheel(0, 24);
    for (const int from : {24, 30, 36, 42})
        rectangles.push_back({from, 0, from + 6, 16});
    const Grid grid{48, 16,
                    [bump](double i, double j) {
                        const double angle = std::numbers::pi / 24 * i;
                        const bool isInside = i > 8 && i < 16 && j > 6 && j < 10;
                        const double radius = 3 + (isInside ? bump : 0);
                        return Point(radius * std::cos(angle), radius * std::sin(angle), 0.2 * j);
                    },
                    true};
    FitOptions options;
    options.tolerance.value = 0.01;
    return fitted(grid, rectangles, options);
}

} // namespace qm::test
