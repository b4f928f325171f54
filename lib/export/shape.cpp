#include "export/shape.h"

#include "bspline/bounding_box.h"
#include "bspline/clamped_patch.h"
#include "export/curve_on_surface.h"
#include "export/geometry.h"
#include "export/shared_edges.h"
#include "export/simple_surface.h"

#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRep_Builder.hxx>
#include <GProp_GProps.hxx>
#include <Geom2d_Line.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <Precision.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <array>
#include <utility>

namespace qm {
namespace {

/// How far the control points of a plane patch may be from its plane, in shares of the mesh's diagonal.
constexpr double planeTolerance = 1e-7;
/// Programs take two faces for one smooth surface below this angle, in degrees: 0.01 radians.
constexpr double smoothAngle = 0.57;

/// The smallest tolerance. Files have 13 digits: points that are one may be that far apart when read back.
double resolution(const QuadMesh& mesh) {
    double largest = 0;
    for (const VertexId vertex : mesh.vertices())
        largest = std::max(largest, mesh.point(vertex).max_abs());
    return std::max(Precision::Confusion(), 4e-12 * largest);
}

/// The surface of a face. One that is simple needs no curves in its parameter plane to be agreed upon.
struct FaceSurface {
    Handle(Geom_Surface) surface;
    Handle(Geom_ElementarySurface) simple; ///< the same, or none if it is a spline surface
    bool reversed = false;                 ///< its normal is not the patch's
};

FaceSurface faceSurface(const Patch& patch, double flatness, double simplify) {
    auto found = planeOf(patch, flatness);
    if (!found && simplify > 0) found = simpleSurfaceOf(patch, simplify);
    if (found) return {found->surface, found->surface, found->reversed};
    return {splineSurface(patch), nullptr, false};
}

class ShapeBuilder {
public:
    ShapeBuilder(const QuadMesh& mesh, const FacePatches& faces, double simplify)
        : layout_(faces.layout), patches_(faces.patches), resolution_(resolution(mesh)),
          shared_(shareEdges(mesh, faces.layout, faces.patches)), vertices_(mesh.n_vertices()),
          borders_(faces.patches.size()) {
        const double flatness = std::max(resolution_ / 2, planeTolerance * boundingBoxDiagonal(mesh));
        for (const Patch& patch : patches_)
            surfaces_.push_back(faceSurface(patch, flatness, simplify));
        for (const SharedEdge& edge : shared_.edges)
            makeEdge(edge);
        makeVertices();
    }

    BoundaryShape build() {
        BoundaryShape result;
        for (std::size_t k = 0; k < patches_.size(); ++k)
            result.faces.push_back(makeFace(k));
        assemble(result);
        return result;
    }

private:
    /// A tolerance has to cover a gap, with a margin for what lies between the samples.
    [[nodiscard]] double toleranceFor(double gap) const { return std::max(1.1 * gap, resolution_); }

    /// Made once, as one side may be many edges.
    const SplineCurve& border(std::size_t patch, int side) {
        SplineCurve& curve = borders_[patch][static_cast<std::size_t>(side)];
        if (curve.points.empty()) curve = borderCurve(patches_[patch], side);
        return curve;
    }

    /// Its curve is the border of the first patch that uses it. Vertices come when all tolerances are known.
    void makeEdge(const SharedEdge& edge) {
        const BorderPlace& at = edge.places.front();
        const Handle(Geom_BSplineCurve) curve =
            splineCurve(restricted(border(at.patch, at.side), at.position, at.position + edge.length));
        Edge& made = edges_.emplace_back();
        double gap = edge.gap;
        for (std::size_t use = 0; use < edge.places.size(); ++use) {
            const FaceSurface& on = surfaces_[edge.places[use].patch];
            if (on.simple.IsNull()) {
                made.inPlane.at(use) = inPlane(edge, use);
            } else {
                const CurveOnSurface found = curveOnSurface(curve, on.simple);
                made.inPlane.at(use) = found.curve;
                gap = std::max(gap, found.gap);
            }
        }
        made.tolerance = toleranceFor(gap);
        builder_.MakeEdge(made.edge, curve, made.tolerance);
        for (const VertexId vertex : {edge.start, edge.end}) {
            double& reach = shared_.vertexGap[static_cast<std::size_t>(vertex.idx())];
            reach = std::max(reach, gap);
        }
    }

    void makeVertices() {
        for (std::size_t e = 0; e < edges_.size(); ++e) {
            const SharedEdge& edge = shared_.edges[e];
            builder_.Add(edges_[e].edge, vertexAt(edge.start).Oriented(TopAbs_FORWARD));
            builder_.Add(edges_[e].edge, vertexAt(edge.end).Oriented(TopAbs_REVERSED));
            builder_.Range(edges_[e].edge, 0, edge.length);
        }
    }

    const TopoDS_Vertex& vertexAt(VertexId vertex) {
        const auto index = static_cast<std::size_t>(vertex.idx());
        if (vertices_[index].IsNull())
            builder_.MakeVertex(vertices_[index], place(shared_.vertexPoint[index]),
                                toleranceFor(shared_.vertexGap[index]));
        return vertices_[index];
    }

    /// An edge in the parameter plane of a patch that uses it; it runs in the edge's own direction.
    [[nodiscard]] Handle(Geom2d_Curve) inPlane(const SharedEdge& edge, std::size_t use) const {
        const BorderPlace& at = edge.places[use];
        const auto& size = layout_.segments[at.patch].size;
        auto from = parametersOnSide(size, at.side, at.position);
        auto to = parametersOnSide(size, at.side, at.position + edge.length);
        if (use > 0) std::swap(from, to);
        const Handle(Geom2d_Line) line =
            new Geom2d_Line(gp_Pnt2d(from[0], from[1]), gp_Dir2d(to[0] - from[0], to[1] - from[1]));
        return new Geom2d_TrimmedCurve(line, 0, edge.length);
    }

    TopoDS_Face makeFace(std::size_t patch) {
        const FaceSurface& on = surfaces_[patch];
        TopoDS_Face face;
        builder_.MakeFace(face, on.surface, resolution_);
        TopoDS_Wire wire;
        builder_.MakeWire(wire);
        for (const EdgeUse& use : shared_.ofPatch[patch]) {
            const Edge& made = edges_[use.edge];
            if (const auto& curve = made.inPlane.at(use.forwards ? 0 : 1); !curve.IsNull()) {
                builder_.UpdateEdge(made.edge, curve, face, made.tolerance);
                builder_.Range(made.edge, face, 0, shared_.edges[use.edge].length);
            }
            builder_.Add(wire, made.edge.Oriented(use.forwards ? TopAbs_FORWARD : TopAbs_REVERSED));
        }
        wire.Closed(true);
        builder_.Add(face, on.reversed ? wire.Reversed() : wire);
        if (on.reversed) face.Reverse();
        return face;
    }

    void assemble(BoundaryShape& result) {
        const auto component = patchComponents(shared_);
        const std::size_t count =
            component.empty() ? 0 : *std::max_element(component.begin(), component.end()) + 1;
        std::vector<TopoDS_Shell> shells(count);
        std::vector<bool> closed(count, true);
        for (TopoDS_Shell& shell : shells)
            builder_.MakeShell(shell);
        for (std::size_t k = 0; k < result.faces.size(); ++k)
            builder_.Add(shells[component[k]], result.faces[k]);
        for (const SharedEdge& edge : shared_.edges)
            if (edge.places.size() < 2) {
                closed[component[edge.places.front().patch]] = false;
                ++result.report.openEdges;
            } else if (edge.angle < smoothAngle) {
                ++result.report.smoothEdges;
            }
        std::vector<TopoDS_Shape> parts;
        for (std::size_t k = 0; k < count; ++k) {
            shells[k].Closed(closed[k]);
            parts.push_back(closed[k] ? TopoDS_Shape(solid(shells[k])) : TopoDS_Shape(shells[k]));
            ++(closed[k] ? result.report.solids : result.report.shells);
        }
        result.shape = parts.size() == 1 ? parts.front() : compound(parts);
        result.report.faces = result.faces.size();
        result.report.edges = edges_.size();
        for (const double gap : shared_.vertexGap)
            result.report.largestTolerance = std::max(result.report.largestTolerance, toleranceFor(gap));
        for (const FaceSurface& surface : surfaces_)
            if (!surface.simple.IsNull()) ++result.report.simpleFaces;
        result.report.valid = BRepCheck_Analyzer(result.shape).IsValid();
    }

    TopoDS_Shape compound(const std::vector<TopoDS_Shape>& parts) {
        TopoDS_Compound result;
        builder_.MakeCompound(result);
        for (const TopoDS_Shape& part : parts)
            builder_.Add(result, part);
        return result;
    }

    /// A mesh whose faces look inwards encloses a negative volume; its solid is the inside all the same.
    TopoDS_Solid solid(const TopoDS_Shell& shell) {
        GProp_GProps volume;
        BRepGProp::VolumeProperties(shell, volume);
        TopoDS_Solid result;
        builder_.MakeSolid(result);
        builder_.Add(result, volume.Mass() < 0 ? shell.Reversed() : TopoDS_Shape(shell));
        return result;
    }

    struct Edge {
        TopoDS_Edge edge;
        std::array<Handle(Geom2d_Curve), 2> inPlane; ///< of its uses; none in planes
        double tolerance = 0;
    };

    const Layout& layout_;
    const std::vector<Patch>& patches_;
    double resolution_;
    SharedEdges shared_;
    std::vector<TopoDS_Vertex> vertices_;
    std::vector<std::array<SplineCurve, 4>> borders_; ///< of the sides; empty until they are needed
    std::vector<FaceSurface> surfaces_;
    std::vector<Edge> edges_;
    BRep_Builder builder_;
};

} // namespace

BoundaryShape buildShape(const QuadMesh& mesh, const FacePatches& faces, double simplify) {
    return ShapeBuilder(mesh, faces, simplify).build();
}

} // namespace qm
