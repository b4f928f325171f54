#include "export/boundary/simple_faces.h"

#include "base/at.h"
#include "bspline/measure/border_measures.h"
#include "bspline/splines/eigen_point.h"
#include "export/geometry/geometry.h"
#include "export/simple/conic_curve.h"
#include "export/simple/curve_on_surface.h"
#include "export/simple/straight_seam.h"

#include <algorithm>
#include <array>
#include <utility>

namespace qm {
namespace {

using Surfaces = std::vector<std::optional<SimpleSurface>>;

/// How far vertices and edges may move, in the tolerances of simple faces.
struct Reach {
    static constexpr double ofSimple = 4;
    /// Where other faces meet, too: the edges between these stay, and end where the vertex was.
    static constexpr double besideOthers = 0.25;
};

std::array<gp_Pnt, 2> endsOf(const SharedEdge& edge, const SharedEdges& shared) {
    return {toGp(shared.vertexPoint[at(edge.start)]), toGp(shared.vertexPoint[at(edge.end)])};
}

/// Calls a function with every end of an edge, and each patch that the edge belongs to.
template <class Function> void forEachEnd(const SharedEdges& shared, const Function& function) {
    for (const SharedEdge& edge : shared.edges)
        for (const VertexId vertex : {edge.start, edge.end})
            for (const BorderPlace& place : edge.places)
                function(vertex, place.patch);
}

/// By vertex: the simple faces whose edges end there, in the order of the edges.
std::vector<std::vector<std::size_t>> simpleFacesAt(const SharedEdges& shared, const Surfaces& surfaces) {
    std::vector<std::vector<std::size_t>> facesAt(shared.vertexPoint.size());
    forEachEnd(shared, [&](VertexId vertex, std::size_t patch) {
        auto& faces = facesAt[at(vertex)];
        if (surfaces[patch] && std::ranges::find(faces, patch) == faces.end()) faces.push_back(patch);
    });
    return facesAt;
}

/// The borders where patches meet smoothly.
std::vector<SmoothBorder> smoothBorders(const FacePatches& faces, const SharedEdges& shared) {
    constexpr int perMeshEdge = 4; // steps between samples
    std::vector<SmoothBorder> result;
    for (const SharedEdge& edge : shared.edges) {
        if (edge.places.size() != 2 || !(edge.angle < smoothAngle)) continue;
        const BorderPlace& one = edge.places[0];
        BorderPlace other = edge.places[1]; // walks the edge the other way, from its end
        other.position += edge.length;
        SmoothBorder& border = result.emplace_back();
        border.patches = {one.patch, other.patch};
        for (int k = 0; k <= edge.length * perMeshEdge; ++k) {
            const double along =
                std::clamp(static_cast<double>(k) / perMeshEdge, fromEdgeEnds, edge.length - fromEdgeEnds);
            const SurfacePoint here = pointAt(faces.layout, faces.patches, one, along);
            const SurfacePoint there = pointAt(faces.layout, faces.patches, other, -along);
            const auto normal = unitNormal(here.du, here.dv);
            const auto beside = unitNormal(there.du, there.dv);
            if (!normal || !beside) continue;
            border.points.push_back(vector(here.position));
            border.normals[0].push_back(vector(*normal));
            border.normals[1].push_back(vector(*beside));
        }
    }
    return result;
}

} // namespace

SimpleFaces::SimpleFaces(const FacePatches& faces, const SharedEdges& shared,
                         const SimpleFaceTolerances& tolerances)
    : resolution_(tolerances.resolution), isCommon_(shared.vertexPoint.size()) {
    for (const double tolerance : tolerances.simplify)
        tolerance_ = std::max(tolerance_, tolerance);
    for (const Patch& patch : faces.patches)
        surfaces_.push_back(planeOf(patch, tolerances.flatness));
    if (tolerance_ > 0)
        surfaces_ = simpleSurfacesOf(faces.patches, tolerances.simplify, std::move(surfaces_),
                                     smoothBorders(faces, shared));
}

double SimpleFaces::reach() const {
    return Reach::ofSimple * tolerance_;
}

void SimpleFaces::moveVertices(SharedEdges& shared) {
    if (tolerance_ == 0) return;
    const auto facesAt = simpleFacesAt(shared, surfaces_);
    std::vector<double> reachOf(facesAt.size(), reach());
    forEachEnd(shared, [&](VertexId vertex, std::size_t patch) {
        if (!surfaces_[patch]) reachOf[at(vertex)] = Reach::besideOthers * tolerance_;
    });
    for (std::size_t v = 0; v < facesAt.size(); ++v) {
        if (facesAt[v].size() < 2) continue;
        std::vector<SimpleSurface> surfaces;
        for (const std::size_t face : facesAt[v])
            surfaces.push_back(*surfaces_[face]);
        const gp_Pnt before = toGp(shared.vertexPoint[v]);
        const gp_Pnt after = commonPoint(before, surfaces);
        if (!(after.Distance(before) <= reachOf[v])) continue;
        shared.vertexPoint[v] = fromGp(after);
        isCommon_[v] = true;
    }
    straightenSeams(shared, facesAt);
}

void SimpleFaces::straightenSeams(SharedEdges& shared, const std::vector<std::vector<std::size_t>>& facesAt) {
    std::vector<bool> mayMove = isCommon_;
    for (const SharedEdge& edge : shared.edges)
        for (const BorderPlace& place : edge.places)
            if (!surfaces_[place.patch] || edge.places.size() < 2)
                mayMove[at(edge.start)] = mayMove[at(edge.end)] = false;
    for (const SharedEdge& edge : shared.edges) {
        if (edge.places.size() < 2 || !mayMove[at(edge.start)] || !mayMove[at(edge.end)]) continue;
        const SimpleSurface& seam = *surfaces_[edge.places[0].patch];
        const auto isSeam = [&](std::size_t face) {
            return areOneRuledSurface(seam, *surfaces_[face], resolution_);
        };
        if (!isSeam(edge.places[1].patch)) continue;
        const std::array vertices{at(edge.start), at(edge.end)};
        std::array<gp_Pnt, 2> ends;
        std::array<std::vector<SimpleSurface>, 2> others;
        for (std::size_t k = 0; k < 2; ++k) {
            ends[k] = toGp(shared.vertexPoint[vertices[k]]);
            for (const std::size_t face : facesAt[vertices[k]])
                if (!isSeam(face)) others[k].push_back(*surfaces_[face]);
        }
        const auto moved = straightened(seam, ends, others);
        const auto isGood = [&](std::size_t k) {
            const gp_Pnt& to = (*moved)[k];
            return to.Distance(ends[k]) <= reach() / 2 &&
                   commonPoint(to, others[k]).Distance(to) <= resolution_ / 2;
        };
        if (!moved || !isGood(0) || !isGood(1)) continue;
        for (std::size_t k = 0; k < 2; ++k)
            shared.vertexPoint[vertices[k]] = fromGp((*moved)[k]);
        mayMove[vertices[0]] = mayMove[vertices[1]] = false; // once only
    }
}

std::optional<CurvePiece> SimpleFaces::exactCurve(const SharedEdge& edge, const SharedEdges& shared,
                                                  const Handle(Geom_BSplineCurve) & border) const {
    if (edge.places.size() < 2 || !isCommon_[at(edge.start)] || !isCommon_[at(edge.end)]) return std::nullopt;
    const auto& one = surfaces_[edge.places[0].patch];
    const auto& other = surfaces_[edge.places[1].patch];
    if (!one || !other) return std::nullopt;
    const std::array ends = endsOf(edge, shared);
    const auto curve = commonCurve(border, ends, {*one, *other}, resolution_);
    for (int k = curve->FirstUKnotIndex(); k <= curve->LastUKnotIndex(); ++k)
        if (!(curve->Value(curve->Knot(k)).Distance(border->Value(curve->Knot(k))) <= reach()))
            return std::nullopt;
    const CurvePiece spline = wholeCurve(curve);
    return conicCurve({*one, *other}, ends, spline.middle(), resolution_).value_or(spline);
}

Handle(Geom_BSplineCurve) SimpleFaces::movedBorder(const SharedEdge& edge, const SharedEdges& shared,
                                                   const Handle(Geom_BSplineCurve) & border) const {
    const auto isSimple = [&](const BorderPlace& place) { return surfaces_[place.patch].has_value(); };
    if (tolerance_ == 0 || std::ranges::none_of(edge.places, isSimple)) return border;
    const std::array ends = endsOf(edge, shared);
    if (ends[0].Distance(border->StartPoint()) <= resolution_ &&
        ends[1].Distance(border->EndPoint()) <= resolution_)
        return border;
    return withEnds(border, ends);
}

} // namespace qm
