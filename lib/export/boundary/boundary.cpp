#include "export/boundary/boundary.h"

#include "base/at.h"
#include "base/keep_marked.h"
#include "bspline/splines/clamped_patch.h"
#include "export/boundary/edge_angle.h"
#include "export/boundary/simple_faces.h"
#include "export/geometry/geometry.h"
#include "export/simple/curve_on_surface.h"
#include "mesh/bounding_box.h"

#include <Geom_Plane.hxx>
#include <Precision.hxx>
#include <algorithm>
#include <utility>

namespace qm {
namespace {

/// How far the control points of a plane patch may be from its plane, in shares of the mesh's diagonal.
constexpr double planeTolerance = 1e-7;
/// A tolerance covers so many times a gap that was sampled: between the samples it may be larger.
constexpr double gapMargin = 1.1;

/// The smallest tolerance: what OpenCASCADE takes for equal, and coordinates can tell apart.
double resolution(const QuadMesh& mesh) {
    double largest = 0;
    for (const VertexId vertex : mesh.vertices())
        largest = std::max(largest, mesh.point(vertex).max_abs());
    constexpr double digits = 4e-12; // of a coordinate, with those that computing with it takes
    return std::max(Precision::Confusion(), digits * largest);
}

/// The boundary in the making.
class Maker {
public:
    Maker(const QuadMesh& mesh, const FacePatches& faces, const std::vector<double>& simplify)
        : mesh_(mesh), layout_(faces.layout), patches_(faces.patches), resolution_(resolution(mesh)),
          flatness_(std::max(resolution_ / 2, planeTolerance * boundingBox(mesh).diagonal())),
          shared_(shareEdges(mesh, faces.layout, faces.patches)),
          simple_(faces, shared_, {flatness_, resolution_, simplify}) {
        simple_.moveVertices(shared_);
    }

    Boundary make() {
        result_.resolution = resolution_;
        result_.flatness = flatness_;
        makeFaces();
        for (const SharedEdge& edge : shared_.edges)
            makeEdge(edge);
        makeVertices();
        result_.parts = boundaryParts(mesh_, layout_, shared_);
        return std::move(result_);
    }

private:
    void makeFaces() {
        for (std::size_t k = 0; k < patches_.size(); ++k) {
            const auto& found = simple_[k];
            const Handle(Geom_Surface) surface =
                found ? Handle(Geom_Surface)(found->surface) : splineSurface(patches_[k]);
            result_.faces.push_back(
                {surface, found && found->reversed, found.has_value(), {shared_.ofPatch[k]}});
        }
    }

    /// An edge in the parameter plane of a patch that uses it; it runs in the edge's own direction.
    [[nodiscard]] Handle(Geom2d_BSplineCurve) inPlane(const SharedEdge& edge, std::size_t use) const {
        const BorderPlace& at = edge.places[use];
        auto from = parametersAt(layout_, at, 0);
        auto to = parametersAt(layout_, at, edge.length);
        if (use > 0) std::swap(from, to);
        return line({from[0], from[1]}, {to[0], to[1]}, 0, edge.length);
    }

    /// Its curve is the border of the first patch that uses it, if not better known.
    void makeEdge(const SharedEdge& edge) {
        const BorderPlace& at = edge.places.front();
        BoundaryEdge& made = result_.edges.emplace_back();
        const Handle(Geom_BSplineCurve) known = splineCurve(
            restricted(borderCurve(patches_[at.patch], at.side), at.position, at.position + edge.length));
        made.curve = simple_.exactCurve(edge, shared_, known)
                         .value_or(wholeCurve(simple_.movedBorder(edge, shared_, known)));
        result_.largestGap = std::max(result_.largestGap, edge.gap);
        // An end moves farthest, see `movedBorder`.
        const double moved = std::max(made.curve.start().Distance(known->StartPoint()),
                                      made.curve.end().Distance(known->EndPoint()));
        double gap = edge.gap;
        for (std::size_t use = 0; use < edge.places.size(); ++use) {
            const auto& simple = simple_[edge.places[use].patch];
            if (!simple) {
                made.onFaces.at(use) = inPlane(edge, use);
                gap = std::max(gap, edge.gap + moved);
            } else {
                const CurveOnSurface found = curveOnSurface(made.curve, *simple, resolution_);
                made.onFaces.at(use) = found.curve;
                gap = std::max(gap, found.gap);
            }
        }
        made.tolerance = toleranceOf(gap, resolution_);
        made.isOpen = edge.places.size() < 2;
        made.isSmooth = !made.isOpen && edge.angle < smoothAngle;
        const auto isSimple = [&](const BorderPlace& place) { return simple_[place.patch].has_value(); };
        if (!made.isSmooth || !simple_.isAnalytic() || std::ranges::none_of(edge.places, isSimple)) return;
        made.newAngle =
            largestAngle(made, {&result_.faces[edge.places[0].patch], &result_.faces[edge.places[1].patch]},
                         fromEdgeEnds / edge.length);
        made.isSmooth = made.newAngle < smoothAngle;
    }

    /// When all edges are known: their tolerances reach to where they end.
    void makeVertices() {
        std::vector<std::ptrdiff_t> number(mesh_.n_vertices(), -1);
        for (std::size_t e = 0; e < result_.edges.size(); ++e)
            for (const bool atEnd : {false, true}) {
                const VertexId vertex = atEnd ? shared_.edges[e].end : shared_.edges[e].start;
                const std::size_t v = at(vertex);
                if (number[v] < 0) {
                    number[v] = static_cast<std::ptrdiff_t>(result_.vertices.size());
                    result_.vertices.push_back({toGp(shared_.vertexPoint[v]), resolution_});
                }
                BoundaryEdge& edge = result_.edges[e];
                edge.ends.at(atEnd ? 1 : 0) = at(number[v]);
                BoundaryVertex& made = result_.vertices[at(number[v])];
                const double gap = made.point.Distance(atEnd ? edge.curve.end() : edge.curve.start());
                made.tolerance =
                    std::max(made.tolerance, edge.tolerance + (gap > resolution_ ? gapMargin * gap : 0));
            }
    }

    const QuadMesh& mesh_;
    const Layout& layout_;
    const std::vector<Patch>& patches_;
    double resolution_;
    double flatness_;
    SharedEdges shared_;
    SimpleFaces simple_;
    Boundary result_;
};

} // namespace

double toleranceOf(double gap, double resolution) {
    return std::max(gapMargin * gap, resolution);
}

double maxLength(const BoundaryEdge& edge) {
    double length = 0;
    const std::vector<gp_Pnt> points = controlPoints(edge.curve);
    for (std::size_t k = 1; k < points.size(); ++k)
        length += points[k - 1].Distance(points[k]);
    return length;
}

double largestTolerance(const Boundary& boundary) {
    double largest = 0;
    for (const BoundaryVertex& vertex : boundary.vertices)
        largest = std::max(largest, vertex.tolerance);
    return largest;
}

void raiseTolerance(Boundary& boundary, std::size_t edge, double tolerance) {
    BoundaryEdge& raised = boundary.edges[edge];
    raised.tolerance = std::max(raised.tolerance, tolerance);
    for (const std::size_t end : raised.ends)
        boundary.vertices[end].tolerance = std::max(boundary.vertices[end].tolerance, raised.tolerance);
}

void dropUnused(Boundary& boundary) {
    std::vector<bool> isUsed(boundary.edges.size());
    forEachUse(boundary, [&](std::size_t, const EdgeUse& use) { isUsed[use.edge] = true; });
    const auto edgeNumbers = keepMarked(boundary.edges, isUsed);
    for (BoundaryFace& face : boundary.faces)
        for (auto& loop : face.loops)
            for (EdgeUse& use : loop)
                use.edge = edgeNumbers[use.edge];
    isUsed.assign(boundary.vertices.size(), false);
    for (const BoundaryEdge& edge : boundary.edges)
        isUsed[edge.ends[0]] = isUsed[edge.ends[1]] = true;
    const auto vertexNumbers = keepMarked(boundary.vertices, isUsed);
    for (BoundaryEdge& edge : boundary.edges)
        for (std::size_t& end : edge.ends)
            end = vertexNumbers[end];
}

gp_Pnt2d parametersAt(const BoundaryFace& face, const BoundaryEdge& edge, std::size_t side,
                      double parameter) {
    if (const auto& curve = edge.onFaces.at(side); !curve.IsNull()) return curve->Value(parameter);
    return parametersAt(Handle(Geom_Plane)::DownCast(face.surface), edge.curve.at(parameter));
}

std::vector<std::vector<std::size_t>> facesOfEdges(const Boundary& boundary) {
    std::vector<std::vector<std::size_t>> result(boundary.edges.size());
    forEachUse(boundary, [&](std::size_t face, const EdgeUse& use) { result[use.edge].push_back(face); });
    return result;
}

Boundary makeBoundary(const QuadMesh& mesh, const FacePatches& faces, const std::vector<double>& simplify) {
    return Maker(mesh, faces, simplify).make();
}

} // namespace qm
