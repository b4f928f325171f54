#include "export/shape.h"

#include "base/error.h"
#include "bspline/borders.h"
#include "bspline/clamped_patch.h"
#include "bspline/evaluate.h"

#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRep_Builder.hxx>
#include <GProp_GProps.hxx>
#include <Geom2d_Line.hxx>
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
#include <cmath>
#include <string>

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
    std::vector<double> distinct = knots;
    distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
    const auto size = static_cast<int>(distinct.size());
    KnotTable table{TColStd_Array1OfReal(1, size), TColStd_Array1OfInteger(1, size)};
    for (int k = 0; k < size; ++k) {
        const double knot = distinct[static_cast<std::size_t>(k)];
        table.values.SetValue(k + 1, knot);
        table.multiplicities.SetValue(k + 1, static_cast<int>(std::count(knots.begin(), knots.end(), knot)));
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
    return new Geom_BSplineSurface(poles, u.values, v.values, u.multiplicities, v.multiplicities, 3, 3);
}

Handle(Geom_BSplineCurve) curve(const SplineCurve& spline) {
    TColgp_Array1OfPnt poles(1, static_cast<int>(spline.points.size()));
    for (int k = 0; k < poles.Length(); ++k)
        poles.SetValue(k + 1, place(spline.points[static_cast<std::size_t>(k)]));
    const KnotTable knots = knotTable(spline.knots);
    return new Geom_BSplineCurve(poles, knots.values, knots.multiplicities, 3);
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
        if (patch.degree != std::array{3, 3}) throw Error(name, "is not bicubic", "Fit the surfaces anew");
        for (std::size_t d = 0; d < 2; ++d) {
            const auto& knots = patch.knots[d];
            const bool counts =
                patch.count[d] >= 4 && knots.size() == static_cast<std::size_t>(patch.count[d]) + 4;
            if (!counts || !std::is_sorted(knots.begin(), knots.end()) ||
                domain(knots, 3) != std::array<double, 2>{0, static_cast<double>(layout.segments[k].size[d])})
                throw Error(name, "has knots that do not belong to its segment", "Fit the surfaces anew");
        }
        if (patch.controlPoints.size() !=
            static_cast<std::size_t>(patch.count[0]) * static_cast<std::size_t>(patch.count[1]))
            throw Error(name, "has a wrong number of control points", "Fit the surfaces anew");
    }
}

/// A run of border edges between two vertices where borders meet.
struct SharedEdge {
    TopoDS_Edge edge;
    std::vector<BorderPlace> places; ///< of its first border edge as each patch walks it
    int length = 0;
    double tolerance = 0;
    VertexId start; ///< in the direction of the first place
    VertexId end;
};

class ShapeBuilder {
public:
    ShapeBuilder(const QuadMesh& mesh, const Layout& layout, const std::vector<Patch>& patches)
        : mesh_(mesh), layout_(layout), borders_(borderEdges(mesh, layout)), vertices_(mesh.n_vertices()),
          vertexTolerance_(mesh.n_vertices(), Precision::Confusion()) {
        for (const Patch& patch : patches)
            patches_.push_back(clamped(patch));
        indexBorders();
        makeEdges();
    }

    BoundaryShape build() {
        BoundaryShape result;
        for (std::size_t k = 0; k < patches_.size(); ++k)
            result.faces.push_back(makeFace(k));
        assemble(result);
        return result;
    }

private:
    /// Which border edge lies where on which side, and the vertices where borders meet.
    void indexBorders() {
        borderAt_.resize(patches_.size());
        std::vector<int> valence(mesh_.n_vertices(), 0);
        for (std::size_t s = 0; s < patches_.size(); ++s)
            for (std::size_t side = 0; side < 4; ++side)
                borderAt_[s][side].resize(layout_.segments[s].sides[side].size() - 1);
        for (std::size_t b = 0; b < borders_.size(); ++b) {
            for (const BorderPlace& at : borders_[b].places)
                borderAt_[at.patch][static_cast<std::size_t>(at.side)]
                         [static_cast<std::size_t>(at.position)] = b;
            ++valence[index(mesh_.from_vertex_handle(borders_[b].halfedge))];
            ++valence[index(mesh_.to_vertex_handle(borders_[b].halfedge))];
        }
        isNode_.resize(mesh_.n_vertices());
        for (std::size_t v = 0; v < valence.size(); ++v)
            isNode_[v] = valence[v] > 2;
        for (const Segment& segment : layout_.segments)
            for (const VertexId corner : segment.corners)
                isNode_[index(corner)] = true;
    }

    static std::size_t index(VertexId vertex) { return static_cast<std::size_t>(vertex.idx()); }

    /// Cuts every side at the vertices where borders meet. The first patch that comes along makes the edge.
    void makeEdges() {
        edgeOfBorder_.assign(borders_.size(), -1);
        for (std::size_t s = 0; s < patches_.size(); ++s)
            for (int side = 0; side < 4; ++side) {
                const auto& line = borderAt_[s][static_cast<std::size_t>(side)];
                const auto& vertices = layout_.segments[s].sides[static_cast<std::size_t>(side)];
                std::size_t begin = 0;
                for (std::size_t k = 1; k < vertices.size(); ++k) {
                    if (!isNode_[index(vertices[k])]) continue;
                    const BorderPlace at{s, side, static_cast<int>(begin)};
                    addUse(at, static_cast<int>(k - begin), line, vertices);
                    begin = k;
                }
            }
        for (SharedEdge& shared : edges_)
            measure(shared);
        for (SharedEdge& shared : edges_)
            finish(shared);
    }

    void addUse(const BorderPlace& at, int length, const std::vector<std::size_t>& line,
                const std::vector<VertexId>& vertices) {
        const auto begin = static_cast<std::size_t>(at.position);
        auto& number = edgeOfBorder_[line[begin]];
        if (number >= 0) {
            edges_[static_cast<std::size_t>(number)].places.push_back(at);
            return;
        }
        for (int k = 0; k < length; ++k)
            edgeOfBorder_[line[begin + static_cast<std::size_t>(k)]] =
                static_cast<std::ptrdiff_t>(edges_.size());
        SharedEdge shared;
        shared.places.push_back(at);
        shared.length = length;
        shared.start = vertices[begin];
        shared.end = vertices[begin + static_cast<std::size_t>(length)];
        edges_.push_back(shared);
    }

    [[nodiscard]] Point pointOn(const BorderPlace& at, double along) const {
        const auto [u, v] = parametersOnSide(layout_.segments[at.patch].size, at.side, at.position + along);
        return evaluate(patches_[at.patch], u, v).position;
    }

    /// How far apart the patches are along an edge, and from its vertices at the ends.
    void measure(SharedEdge& shared) {
        constexpr int steps = 8;
        double gap = 0;
        for (int k = 0; k <= shared.length * steps && shared.places.size() > 1; ++k) {
            const double along = static_cast<double>(k) / steps;
            gap = std::max(
                gap,
                (pointOn(shared.places[0], along) - pointOn(shared.places[1], shared.length - along)).norm());
        }
        shared.tolerance = std::max(1.1 * gap, Precision::Confusion());
        for (const BorderPlace& at : shared.places) {
            const bool forwards = &at == &shared.places.front();
            for (const bool atEnd : {false, true}) {
                const VertexId vertex = atEnd == forwards ? shared.end : shared.start;
                const double away = (pointOn(at, atEnd ? shared.length : 0) - mesh_.point(vertex)).norm();
                double& tolerance = vertexTolerance_[index(vertex)];
                tolerance = std::max({tolerance, shared.tolerance, away + shared.tolerance});
            }
        }
    }

    const TopoDS_Vertex& vertexAt(VertexId vertex) {
        TopoDS_Vertex& result = vertices_[index(vertex)];
        if (result.IsNull())
            builder_.MakeVertex(result, place(mesh_.point(vertex)), vertexTolerance_[index(vertex)]);
        return result;
    }

    void finish(SharedEdge& shared) {
        const BorderPlace& at = shared.places.front();
        const SplineCurve border = borderCurve(patches_[at.patch], at.side);
        const SplineCurve part = restricted(border, at.position, at.position + shared.length);
        builder_.MakeEdge(shared.edge, curve(part), shared.tolerance);
        builder_.Add(shared.edge, vertexAt(shared.start).Oriented(TopAbs_FORWARD));
        builder_.Add(shared.edge, vertexAt(shared.end).Oriented(TopAbs_REVERSED));
        builder_.Range(shared.edge, 0, shared.length);
    }

    /// The edge in a patch's parameter plane; it runs in the direction of its first place.
    [[nodiscard]] Handle(Geom2d_Line) inPlane(const SharedEdge& shared, std::size_t use) const {
        const BorderPlace& at = shared.places[use];
        const auto& size = layout_.segments[at.patch].size;
        auto from = parametersOnSide(size, at.side, at.position);
        auto to = parametersOnSide(size, at.side, at.position + shared.length);
        if (use > 0) std::swap(from, to);
        return new Geom2d_Line(gp_Pnt2d(from[0], from[1]), gp_Dir2d(to[0] - from[0], to[1] - from[1]));
    }

    TopoDS_Face makeFace(std::size_t patch) {
        TopoDS_Face face;
        builder_.MakeFace(face, surface(patches_[patch]), Precision::Confusion());
        TopoDS_Wire wire;
        builder_.MakeWire(wire);
        for (int side = 0; side < 4; ++side) {
            const auto& line = borderAt_[patch][static_cast<std::size_t>(side)];
            for (std::size_t k = 0; k < line.size();) {
                SharedEdge& shared = edges_[static_cast<std::size_t>(edgeOfBorder_[line[k]])];
                const BorderPlace& first = shared.places.front();
                const bool forwards =
                    first.patch == patch && first.side == side && first.position == static_cast<int>(k);
                placeOn(shared, forwards ? 0 : 1, face);
                builder_.Add(wire, shared.edge.Oriented(forwards ? TopAbs_FORWARD : TopAbs_REVERSED));
                k += static_cast<std::size_t>(shared.length);
            }
        }
        wire.Closed(true);
        builder_.Add(face, wire);
        return face;
    }

    void placeOn(SharedEdge& shared, std::size_t use, const TopoDS_Face& face) {
        const bool seam = shared.places.size() == 2 && shared.places[0].patch == shared.places[1].patch;
        if (seam)
            builder_.UpdateEdge(shared.edge, inPlane(shared, 0), inPlane(shared, 1), face, shared.tolerance);
        else
            builder_.UpdateEdge(shared.edge, inPlane(shared, use), face, shared.tolerance);
        builder_.Range(shared.edge, face, 0, shared.length);
    }

    /// Which component each patch belongs to, numbered in the order of the patches.
    [[nodiscard]] std::vector<std::size_t> components(std::size_t& count) const {
        std::vector<std::size_t> parent(patches_.size());
        for (std::size_t k = 0; k < parent.size(); ++k)
            parent[k] = k;
        const auto root = [&](std::size_t k) {
            while (parent[k] != k)
                k = parent[k] = parent[parent[k]];
            return k;
        };
        for (const SharedEdge& shared : edges_)
            for (const BorderPlace& at : shared.places) {
                const std::size_t a = root(shared.places.front().patch);
                const std::size_t b = root(at.patch);
                parent[std::max(a, b)] = std::min(a, b);
            }
        std::vector<std::size_t> component(parent.size());
        count = 0;
        for (std::size_t k = 0; k < parent.size(); ++k)
            component[k] = root(k) == k ? count++ : component[root(k)];
        return component;
    }

    void assemble(BoundaryShape& result) {
        std::size_t count = 0;
        const auto component = components(count);
        std::vector<TopoDS_Shell> shells(count);
        std::vector<bool> closed(count, true);
        for (TopoDS_Shell& shell : shells)
            builder_.MakeShell(shell);
        for (std::size_t k = 0; k < result.faces.size(); ++k)
            builder_.Add(shells[component[k]], result.faces[k]);
        for (const SharedEdge& shared : edges_)
            if (shared.places.size() < 2) {
                closed[component[shared.places.front().patch]] = false;
                ++result.report.openEdges;
            }
        std::vector<TopoDS_Shape> parts;
        for (std::size_t k = 0; k < count; ++k) {
            shells[k].Closed(closed[k]);
            parts.push_back(closed[k] ? TopoDS_Shape(solid(shells[k])) : TopoDS_Shape(shells[k]));
            ++(closed[k] ? result.report.solids : result.report.shells);
        }
        if (parts.size() == 1) {
            result.shape = parts.front();
        } else {
            TopoDS_Compound compound;
            builder_.MakeCompound(compound);
            for (const TopoDS_Shape& part : parts)
                builder_.Add(compound, part);
            result.shape = compound;
        }
        result.report.faces = result.faces.size();
        result.report.edges = edges_.size();
        for (const double tolerance : vertexTolerance_)
            result.report.largestTolerance = std::max(result.report.largestTolerance, tolerance);
        result.report.valid = BRepCheck_Analyzer(result.shape).IsValid();
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
    std::vector<Patch> patches_; ///< clamped
    std::vector<BorderEdge> borders_;
    std::vector<std::array<std::vector<std::size_t>, 4>> borderAt_;
    std::vector<bool> isNode_;
    std::vector<SharedEdge> edges_;
    std::vector<std::ptrdiff_t> edgeOfBorder_;
    std::vector<TopoDS_Vertex> vertices_;
    std::vector<double> vertexTolerance_;
    BRep_Builder builder_;
};

} // namespace

BoundaryShape buildShape(const QuadMesh& mesh, const Layout& layout, const std::vector<Patch>& patches) {
    requireMatching(layout, patches);
    return ShapeBuilder(mesh, layout, patches).build();
}

} // namespace qm
