#include "export/export.h"

#include "base/error.h"
#include "base/positions.h"
#include "export/faces/face_patches.h"
#include "export/files/boundary_files.h"
#include "export/files/checked_shape.h"
#include "export/quads.h"
#include "mesh/bounding_box.h"

#include <Standard_Failure.hxx>
#include <algorithm>
#include <functional>
#include <utility>

namespace qm {
namespace {

/// How far points may move where knots are removed, in shares of the mesh's diagonal: by rounding only.
constexpr double knotTolerance = 1e-10;

const Surfaces& required(const Surfaces* surfaces, const std::string& forWhat) {
    if (surfaces == nullptr)
        throw Error("surfaces", "missing, but needed for " + forWhat, "Run qm-bspline first");
    return *surfaces;
}

ShapeReport reportOf(const Boundary& boundary) {
    ShapeReport report;
    report.faces = boundary.faces.size();
    report.edges = boundary.edges.size();
    report.openEdges = countWhere(boundary.edges, std::mem_fn(&BoundaryEdge::isOpen));
    report.smoothEdges = countWhere(boundary.edges, std::mem_fn(&BoundaryEdge::isSmooth));
    report.simpleFaces = countWhere(boundary.faces, std::mem_fn(&BoundaryFace::isSimple));
    for (const BoundaryPart& part : boundary.parts)
        ++(!part.closed ? report.shells : part.cavityOf ? report.cavities : report.solids);
    report.lostEdges = countWhere(
        boundary.edges, [&](const BoundaryEdge& edge) { return maxLength(edge) < boundary.resolution; });
    for (const BoundaryEdge& edge : boundary.edges)
        report.largestNewAngle = std::max(report.largestNewAngle, edge.newAngle);
    report.resolution = boundary.resolution;
    report.largestGap = boundary.largestGap;
    report.largestTolerance = largestTolerance(boundary);
    return report;
}

Exported exportShape(const QuadMesh& mesh, const Layout& layout, const Surfaces& surfaces,
                     const ExportOptions& options) {
    try {
        const double diagonal = boundingBox(mesh).diagonal();
        FacePatches faces = facePatches(layout, surfaces.patches);
        if (options.join) faces = joined(std::move(faces), knotTolerance * diagonal);
        faces = withMoreKnotsAlongV(separated(mesh, std::move(faces), knotTolerance * diagonal));
        std::optional<double> simplify;
        if (options.analytic) simplify = options.analyticTolerance.length(diagonal);
        const CheckedShape made = checkedShape(mesh, faces, simplify, options.join);
        Exported result{options.format == ExportFormat::step
                            ? boundaryAsStep(made.boundary, made.origins, options)
                            : shapeAsIges(made.shape, made.origins, options),
                        reportOf(made.boundary)};
        result.shape->valid = made.isValid;
        return result;
    } catch (const Standard_Failure& failure) {
        throw Error("surfaces",
                    std::string("are nothing that OpenCASCADE takes: ") + failure.DynamicType()->Name(),
                    "Fit the surfaces anew");
    }
}

} // namespace

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
