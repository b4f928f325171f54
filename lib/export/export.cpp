#include "export/export.h"

#include "base/error.h"
#include "bspline/bounding_box.h"
#include "export/colours.h"
#include "export/exchange.h"
#include "export/join.h"
#include "export/quads.h"
#include "export/separate.h"
#include "export/shape.h"

#include <Standard_Failure.hxx>

namespace qm {
namespace {

/// How far points may move where knots are removed, in shares of the mesh's diagonal: by rounding only.
constexpr double knotTolerance = 1e-10;

const Surfaces& required(const Surfaces* surfaces, const std::string& forWhat) {
    if (surfaces == nullptr)
        throw Error("surfaces", "missing, but needed for " + forWhat, "Run qm-bspline first");
    return *surfaces;
}

Exported exportShape(const QuadMesh& mesh, const Layout& layout, const Surfaces& surfaces,
                     const ExportOptions& options) {
    try {
        const double diagonal = boundingBoxDiagonal(mesh);
        FacePatches faces = facePatches(layout, surfaces.patches);
        if (options.join) faces = joined(std::move(faces), knotTolerance * diagonal);
        faces = separated(mesh, std::move(faces), knotTolerance * diagonal);
        const double simplify = options.analytic ? options.analyticTolerance / 100 * diagonal : 0;
        const BoundaryShape shape = buildShape(mesh, faces, simplify);
        return {options.format == ExportFormat::step ? shapeAsStep(shape, faces.origins, options.unit)
                                                     : shapeAsIges(shape, faces.origins, options.unit),
                shape.report};
    } catch (const Standard_Failure& failure) {
        throw Error("surfaces",
                    std::string("are nothing that OpenCASCADE takes: ") + failure.DynamicType()->Name(),
                    "Fit the surfaces anew");
    }
}

} // namespace

double inMillimetres(LengthUnit unit) {
    switch (unit) {
    case LengthUnit::cm:
        return 10;
    case LengthUnit::m:
        return 1000;
    case LengthUnit::inch:
        return 25.4;
    default:
        return 1;
    }
}

Exported exportModel(const QuadMesh& mesh, const Layout& layout, const Surfaces* surfaces,
                     const ExportOptions& options) {
    if (options.format == ExportFormat::step || options.format == ExportFormat::iges)
        return exportShape(mesh, layout, required(surfaces, "STEP and IGES"), options);
    if (options.format == ExportFormat::obj) return {quadsAsObj(mesh, layout), std::nullopt};
    if (options.colour == ColourBy::deviation &&
        required(surfaces, "colours by deviation").ofPatch.size() != layout.segments.size())
        throw Error("surfaces", "do not have the deviation of every patch", "Fit the surfaces anew");
    const auto colours = segmentColours(layout, surfaces, options.colour);
    if (options.format == ExportFormat::ply) return {quadsAsPly(mesh, layout, colours), std::nullopt};
    return {quadsAsGlb(mesh, layout, colours), std::nullopt};
}

} // namespace qm
