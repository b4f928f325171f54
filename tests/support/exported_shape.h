/// \file Exported models as OpenCASCADE reads them back, and models for such tests.
#pragma once

#include "export/export.h"
#include "support/fitted_model.h"

#include <BRep_Tool.hxx>
#include <TopAbs_ShapeEnum.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <functional>
#include <string>
#include <vector>

namespace qm::test {

/// A STEP file as a reader takes it.
[[nodiscard]] TopoDS_Shape readStep(const std::string& text);
/// The same of a model; it must be valid.
[[nodiscard]] TopoDS_Shape readBack(const FittedModel& model, const ExportOptions& options = {});

/// All sub-shapes of a kind, each once.
[[nodiscard]] std::vector<TopoDS_Shape> all(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind);

template <class Surface> [[nodiscard]] int countSurfaces(const TopoDS_Shape& shape) {
    int count = 0;
    for (const TopoDS_Shape& face : all(shape, TopAbs_FACE))
        if (!Handle(Surface)::DownCast(BRep_Tool::Surface(TopoDS::Face(face))).IsNull()) ++count;
    return count;
}

[[nodiscard]] int countSmoothEdges(const TopoDS_Shape& shape);

/// Of all faces.
[[nodiscard]] double area(const TopoDS_Shape& shape);

[[nodiscard]] ExportOptions joining();
/// With a tolerance of a tenth of a per cent.
[[nodiscard]] ExportOptions analytic();
[[nodiscard]] ExportOptions joiningAnalytic();

/// A sheet on a surface of revolution; its distance from the axis is a function of the height.
[[nodiscard]] FittedModel revolved(const std::function<double(double)>& radius, bool inwards,
                                   const std::vector<Rectangle>& rectangles = {{0, 0, 28, 16},
                                                                               {28, 0, 64, 16}});

/// Five rectangles around one another: no two share a whole side.
[[nodiscard]] std::vector<Rectangle> pinwheel(int from, int to);

/// A tube of radius 3 and height 3.2: half of it is a pinwheel, with a bump inside the rectangle in its
/// middle, and half of it four strips.
[[nodiscard]] FittedModel tube(double bump = 0);

} // namespace qm::test
