#include "export/boundary.h"

#include "base/at.h"
#include "bspline/splines/bounding_box.h"
#include "bspline/splines/clamped_patch.h"
#include "export/curve_on_surface.h"
#include "export/geometry.h"
#include "export/simple_surface.h"

#include <Precision.hxx>
#include <algorithm>
#include <optional>
#include <utility>

namespace qm {
namespace {

/// How far the control points of a plane patch may be from its plane, in shares of the mesh's diagonal.
constexpr double planeTolerance = 1e-7;
/// Programs take two faces for one smooth surface below this angle, in degrees: 0.01 radians.
constexpr double smoothAngle = 0.57;
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

/// Of a curve's control polygon: the curve is no longer.
double controlLength(const Geom_BSplineCurve& curve) {
    double length = 0;
    for (int k = 1; k < curve.NbPoles(); ++k)
        length += curve.Pole(k).Distance(curve.Pole(k + 1));
    return length;
}

/// Of the mesh's quads, times six: negative if they look inwards.
double signedVolume(const QuadMesh& mesh, const Segment& segment, const Point& origin) {
    double sum = 0;
    for (const FaceId face : segment.faces) {
        std::vector<Point> corners;
        for (const VertexId vertex : mesh.fv_range(face))
            corners.push_back(mesh.point(vertex) - origin);
        for (std::size_t k = 2; k < corners.size(); ++k)
            sum += corners[0] | (corners[k - 1] % corners[k]);
    }
    return sum;
}

/// The boundary in the making.
class Maker {
public:
    Maker(const QuadMesh& mesh, const FacePatches& faces, const std::vector<double>& simplify)
        : mesh_(mesh), layout_(faces.layout), patches_(faces.patches), simplify_(simplify),
          resolution_(resolution(mesh)), shared_(shareEdges(mesh, faces.layout, faces.patches)),
          borders_(faces.patches.size()), isCommon_(mesh.n_vertices()) {
        for (const double tolerance : simplify)
            reach_ = std::max(reach_, 4 * tolerance);
    }

    Boundary make() {
        result_.resolution = resolution_;
        result_.flatness = std::max(resolution_ / 2, planeTolerance * boundingBoxDiagonal(mesh_));
        makeFaces();
        if (reach_ > 0) moveVertices();
        for (const SharedEdge& edge : shared_.edges)
            makeEdge(edge);
        makeVertices();
        makeParts();
        return std::move(result_);
    }

private:
    [[nodiscard]] double toleranceFor(double gap) const { return std::max(gapMargin * gap, resolution_); }

    void makeFaces() {
        for (const Patch& patch : patches_)
            simple_.push_back(planeOf(patch, result_.flatness));
        if (reach_ > 0) recogniseSimple();
        for (std::size_t k = 0; k < patches_.size(); ++k) {
            const auto& found = simple_[k];
            const Handle(Geom_Surface) surface =
                found ? Handle(Geom_Surface)(found->surface) : splineSurface(patches_[k]);
            result_.faces.push_back(
                {surface, found && found->reversed, found.has_value(), {shared_.ofPatch[k]}});
        }
    }

    /// Where faces are not exact planes.
    void recogniseSimple() {
        std::vector<double> tolerances = simplify_;
        for (std::size_t k = 0; k < patches_.size(); ++k)
            if (simple_[k]) tolerances[k] = 0;
        std::vector<std::array<std::size_t, 2>> neighbours;
        for (const SharedEdge& edge : shared_.edges)
            if (edge.places.size() == 2 && edge.angle < smoothAngle)
                neighbours.push_back({edge.places[0].patch, edge.places[1].patch});
        auto found = simpleSurfacesOf(patches_, tolerances, neighbours);
        for (std::size_t k = 0; k < patches_.size(); ++k)
            if (!simple_[k]) simple_[k] = std::move(found[k]);
    }

    /// Vertices of simple faces get on all of these.
    void moveVertices() {
        std::vector<std::vector<std::size_t>> facesAt(mesh_.n_vertices());
        for (const SharedEdge& edge : shared_.edges)
            for (const VertexId vertex : {edge.start, edge.end})
                for (const auto& [patch, side, position] : edge.places)
                    if (auto& faces = facesAt[at(vertex)];
                        simple_[patch] && std::ranges::find(faces, patch) == faces.end())
                        faces.push_back(patch);
        for (std::size_t v = 0; v < facesAt.size(); ++v) {
            if (facesAt[v].size() < 2) continue;
            std::vector<SimpleSurface> surfaces;
            for (const std::size_t face : facesAt[v])
                surfaces.push_back(*simple_[face]);
            const gp_Pnt before = place(shared_.vertexPoint[v]);
            const gp_Pnt after = commonPoint(before, surfaces);
            if (!(after.Distance(before) <= reach_)) continue;
            shared_.vertexPoint[v] = fromPlace(after);
            isCommon_[v] = true;
        }
    }

    /// Where its two simple faces meet; none if that is not near the patches' border.
    [[nodiscard]] Handle(Geom_BSplineCurve)
        exactCurve(const SharedEdge& edge, const Handle(Geom_BSplineCurve) & border) const {
        if (edge.places.size() < 2 || !isCommon_[at(edge.start)] || !isCommon_[at(edge.end)]) return nullptr;
        const auto& one = simple_[edge.places[0].patch];
        const auto& other = simple_[edge.places[1].patch];
        if (!one || !other) return nullptr;
        const std::array ends{place(shared_.vertexPoint[at(edge.start)]),
                              place(shared_.vertexPoint[at(edge.end)])};
        auto curve = commonCurve(border, ends, {*one, *other}, resolution_);
        for (int k = curve->FirstUKnotIndex(); k <= curve->LastUKnotIndex(); ++k)
            if (!(curve->Value(curve->Knot(k)).Distance(border->Value(curve->Knot(k))) <= reach_))
                return nullptr;
        return curve;
    }

    /// Made once, as one side may be many edges.
    const SplineCurve& border(std::size_t patch, int side) {
        SplineCurve& curve = borders_[patch][at(side)];
        if (curve.points.empty()) curve = borderCurve(patches_[patch], side);
        return curve;
    }

    /// An edge in the parameter plane of a patch that uses it; it runs in the edge's own direction.
    [[nodiscard]] Handle(Geom2d_BSplineCurve) inPlane(const SharedEdge& edge, std::size_t use) const {
        const BorderPlace& at = edge.places[use];
        const auto& size = layout_.segments[at.patch].size;
        auto from = parametersOnSide(size, at.side, at.position);
        auto to = parametersOnSide(size, at.side, at.position + edge.length);
        if (use > 0) std::swap(from, to);
        return line({from[0], from[1]}, {to[0], to[1]}, edge.length);
    }

    /// Its curve is the border of the first patch that uses it, if not better known.
    void makeEdge(const SharedEdge& edge) {
        const BorderPlace& at = edge.places.front();
        BoundaryEdge& made = result_.edges.emplace_back();
        made.curve =
            splineCurve(restricted(border(at.patch, at.side), at.position, at.position + edge.length));
        if (const auto exact = exactCurve(edge, made.curve); !exact.IsNull()) made.curve = exact;
        double gap = edge.gap;
        result_.largestGap = std::max(result_.largestGap, gap);
        if (controlLength(*made.curve) < resolution_) ++result_.lostEdges;
        for (std::size_t use = 0; use < edge.places.size(); ++use) {
            const auto& simple = simple_[edge.places[use].patch];
            if (!simple) {
                made.onFaces.at(use) = inPlane(edge, use);
            } else {
                const CurveOnSurface found = curveOnSurface(made.curve, *simple);
                made.onFaces.at(use) = found.curve;
                gap = std::max(gap, found.gap);
            }
        }
        made.tolerance = toleranceFor(gap);
        made.isOpen = edge.places.size() < 2;
        made.isSmooth = !made.isOpen && edge.angle < smoothAngle;
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
                    result_.vertices.push_back({place(shared_.vertexPoint[v]), resolution_});
                }
                BoundaryEdge& edge = result_.edges[e];
                edge.ends.at(atEnd ? 1 : 0) = at(number[v]);
                BoundaryVertex& made = result_.vertices[at(number[v])];
                const double gap =
                    made.point.Distance(atEnd ? edge.curve->EndPoint() : edge.curve->StartPoint());
                made.tolerance =
                    std::max(made.tolerance, edge.tolerance + (gap > resolution_ ? gapMargin * gap : 0));
            }
    }

    void makeParts() {
        const auto component = patchComponents(shared_);
        std::vector<double> volume;
        for (std::size_t k = 0; k < component.size(); ++k) {
            if (component[k] == result_.parts.size()) {
                result_.parts.push_back({{}, true, false});
                volume.push_back(0);
            }
            result_.parts[component[k]].faces.push_back(k);
            volume[component[k]] += signedVolume(mesh_, layout_.segments[k], mesh_.point(VertexId(0)));
        }
        for (const SharedEdge& edge : shared_.edges)
            if (edge.places.size() < 2) result_.parts[component[edge.places.front().patch]].closed = false;
        for (std::size_t k = 0; k < volume.size(); ++k)
            result_.parts[k].inward = result_.parts[k].closed && volume[k] < 0;
    }

    const QuadMesh& mesh_;
    const Layout& layout_;
    const std::vector<Patch>& patches_;
    const std::vector<double>& simplify_;
    double resolution_;
    SharedEdges shared_;
    std::vector<std::array<SplineCurve, 4>> borders_;  ///< of the sides; empty until they are needed
    std::vector<std::optional<SimpleSurface>> simple_; ///< of faces that need no control points
    double reach_ = 0;           ///< how far an edge may move to be where simple surfaces meet
    std::vector<bool> isCommon_; ///< by vertex: it is on all simple faces there
    Boundary result_;
};

} // namespace

double largestTolerance(const Boundary& boundary) {
    double largest = 0;
    for (const BoundaryVertex& vertex : boundary.vertices)
        largest = std::max(largest, vertex.tolerance);
    return largest;
}

Boundary makeBoundary(const QuadMesh& mesh, const FacePatches& faces, const std::vector<double>& simplify) {
    return Maker(mesh, faces, simplify).make();
}

} // namespace qm
