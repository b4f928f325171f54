#include "export/shape.h"

#include "base/error.h"
#include "bspline/splines/basis.h"
#include "bspline/splines/clamped_patch.h"
#include "export/shared_edges.h"

#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRep_Builder.hxx>
#include <GProp_GProps.hxx>
#include <Geom2d_Line.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
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
#include <cmath>
#include <string>
#include <utility>

namespace qm {
namespace {

gp_Pnt place(const Point& point) {
    return {point[0], point[1], point[2]};
}

/// Distinct knots and how often each is there, as OpenCASCADE wants them.
struct KnotTable {
    TColStd_Array1OfReal values;
    TColStd_Array1OfInteger multiplicities;
};

KnotTable knotTable(const std::vector<double>& knots) {
    std::vector<std::pair<double, int>> distinct;
    for (const double knot : knots) {
        if (distinct.empty() || distinct.back().first != knot) distinct.emplace_back(knot, 0);
        ++distinct.back().second;
    }
    const auto size = static_cast<int>(distinct.size());
    KnotTable table{TColStd_Array1OfReal(1, size), TColStd_Array1OfInteger(1, size)};
    for (int k = 0; k < size; ++k) {
        const auto& [knot, multiplicity] = distinct[static_cast<std::size_t>(k)];
        table.values.SetValue(k + 1, knot);
        table.multiplicities.SetValue(k + 1, multiplicity);
    }
    return table;
}

Handle(Geom_BSplineSurface) surface(const Patch& patch) {
    TColgp_Array2OfPnt poles(1, patch.count[0], 1, patch.count[1]);
    for (int j = 0; j < patch.count[1]; ++j)
        for (int i = 0; i < patch.count[0]; ++i)
            poles.SetValue(i + 1, j + 1,
                           place(patch.controlPoints[static_cast<std::size_t>(j) *
                                                         static_cast<std::size_t>(patch.count[0]) +
                                                     static_cast<std::size_t>(i)]));
    const KnotTable u = knotTable(patch.knots[0]);
    const KnotTable v = knotTable(patch.knots[1]);
    return new Geom_BSplineSurface(poles, u.values, v.values, u.multiplicities, v.multiplicities,
                                   patch.degree[0], patch.degree[1]);
}

Handle(Geom_BSplineCurve) curve(const SplineCurve& spline) {
    TColgp_Array1OfPnt poles(1, static_cast<int>(spline.points.size()));
    for (int k = 0; k < poles.Length(); ++k)
        poles.SetValue(k + 1, place(spline.points[static_cast<std::size_t>(k)]));
    const KnotTable knots = knotTable(spline.knots);
    return new Geom_BSplineCurve(poles, knots.values, knots.multiplicities, 3);
}

/// Whether no inner knot is there more often than the degree allows, and none of them at an end.
bool isContinuous(const std::vector<double>& knots, int degree) {
    const auto first = static_cast<std::size_t>(degree);
    const std::size_t last = knots.size() - first - 1;
    for (std::size_t k = first + 1; k < last; ++k)
        if (knots[k] <= knots[first] || knots[k] >= knots[last] || knots[k] >= knots[k + first]) return false;
    return true;
}

void requireMatching(const Layout& layout, const std::vector<Patch>& patches) {
    if (layout.segments.size() != patches.size())
        throw Error("surfaces",
                    "there are " + std::to_string(patches.size()) + " patches for " +
                        std::to_string(layout.segments.size()) + " segments",
                    "Fit the surfaces anew");
    for (std::size_t k = 0; k < patches.size(); ++k) {
        const Patch& patch = patches[k];
        const std::string name = "patch " + std::to_string(k);
        for (std::size_t d = 0; d < 2; ++d) {
            const auto& knots = patch.knots[d];
            const int degree = patch.degree[d];
            const bool cubic = degree == 3 && patch.count[d] >= 4;
            const bool lower = degree > 0 && degree < 3 && patch.count[d] == degree + 1;
            if (!cubic && !lower)
                throw Error(name, "is neither cubic nor of a lower degree without inner knots",
                            "Fit the surfaces anew");
            const std::size_t due =
                static_cast<std::size_t>(patch.count[d]) + static_cast<std::size_t>(degree) + 1;
            if (knots.size() != due || !std::is_sorted(knots.begin(), knots.end()) ||
                (lower && clampedDegree(knots) != degree) ||
                domain(knots, degree) !=
                    std::array<double, 2>{0, static_cast<double>(layout.segments[k].size[d])})
                throw Error(name, "has knots that do not belong to its segment", "Fit the surfaces anew");
            if (!isContinuous(knots, degree))
                throw Error(name, "has one knot so often that it falls apart there", "Fit the surfaces anew");
        }
        if (patch.controlPoints.size() !=
            static_cast<std::size_t>(patch.count[0]) * static_cast<std::size_t>(patch.count[1]))
            throw Error(name, "has a wrong number of control points", "Fit the surfaces anew");
    }
}

/// The smallest tolerance. Files have 13 digits: points that are one may be that far apart when read back.
double resolution(const QuadMesh& mesh) {
    double largest = 0;
    for (const VertexId vertex : mesh.vertices())
        largest = std::max(largest, mesh.point(vertex).max_abs());
    return std::max(Precision::Confusion(), 4e-12 * largest);
}

class ShapeBuilder {
public:
    ShapeBuilder(const QuadMesh& mesh, const Layout& layout, const std::vector<Patch>& patches)
        : mesh_(mesh), layout_(layout), resolution_(resolution(mesh)),
          shared_(shareEdges(mesh, layout, patches)), vertices_(mesh.n_vertices()) {
        for (const Patch& patch : patches)
            patches_.push_back(clamped(patch));
        borders_.resize(patches.size());
        for (const SharedEdge& edge : shared_.edges)
            edges_.push_back(makeEdge(edge));
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

    const TopoDS_Vertex& vertexAt(VertexId vertex) {
        const auto index = static_cast<std::size_t>(vertex.idx());
        if (vertices_[index].IsNull())
            builder_.MakeVertex(vertices_[index], place(mesh_.point(vertex)),
                                toleranceFor(shared_.vertexGap[index]));
        return vertices_[index];
    }

    /// Made once, as one side may be many edges.
    const SplineCurve& border(std::size_t patch, int side) {
        SplineCurve& curve = borders_[patch][static_cast<std::size_t>(side)];
        if (curve.points.empty()) curve = borderCurve(patches_[patch], side);
        return curve;
    }

    /// Its curve is the border of the first patch that uses it.
    TopoDS_Edge makeEdge(const SharedEdge& edge) {
        const BorderPlace& at = edge.places.front();
        const SplineCurve part =
            restricted(border(at.patch, at.side), at.position, at.position + edge.length);
        TopoDS_Edge result;
        builder_.MakeEdge(result, curve(part), toleranceFor(edge.gap));
        builder_.Add(result, vertexAt(edge.start).Oriented(TopAbs_FORWARD));
        builder_.Add(result, vertexAt(edge.end).Oriented(TopAbs_REVERSED));
        builder_.Range(result, 0, edge.length);
        return result;
    }

    /// An edge in the parameter plane of a patch that uses it; it runs in the edge's own direction. It is
    /// bounded, and so keeps its ends in a file: those of a bare line would be sought along the whole side,
    /// which may pass one and the same vertex twice.
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
        TopoDS_Face face;
        builder_.MakeFace(face, surface(patches_[patch]), resolution_);
        TopoDS_Wire wire;
        builder_.MakeWire(wire);
        for (const EdgeUse& use : shared_.ofPatch[patch]) {
            placeOn(use, face);
            builder_.Add(wire, edges_[use.edge].Oriented(use.forwards ? TopAbs_FORWARD : TopAbs_REVERSED));
        }
        wire.Closed(true);
        builder_.Add(face, wire);
        return face;
    }

    void placeOn(const EdgeUse& use, const TopoDS_Face& face) {
        const SharedEdge& edge = shared_.edges[use.edge];
        const TopoDS_Edge& made = edges_[use.edge];
        const double tolerance = toleranceFor(edge.gap);
        if (isSeam(edge))
            builder_.UpdateEdge(made, inPlane(edge, 0), inPlane(edge, 1), face, tolerance);
        else
            builder_.UpdateEdge(made, inPlane(edge, use.forwards ? 0 : 1), face, tolerance);
        builder_.Range(made, face, 0, edge.length);
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

    const QuadMesh& mesh_;
    const Layout& layout_;
    double resolution_;
    SharedEdges shared_;
    std::vector<Patch> patches_;                      ///< clamped
    std::vector<std::array<SplineCurve, 4>> borders_; ///< of the sides; empty until they are needed
    std::vector<TopoDS_Vertex> vertices_;
    std::vector<TopoDS_Edge> edges_;
    BRep_Builder builder_;
};

} // namespace

BoundaryShape buildShape(const QuadMesh& mesh, const Layout& layout, const std::vector<Patch>& patches) {
    requireMatching(layout, patches);
    return ShapeBuilder(mesh, layout, patches).build();
}

} // namespace qm
