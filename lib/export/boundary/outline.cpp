#include "export/boundary/outline.h"

#include "export/simple/curve_on_surface.h"

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/ring.hpp>

#include <Geom_Plane.hxx>
#include <algorithm>
#include <vector>

namespace qm {
namespace {

using PlanePoint = boost::geometry::model::d2::point_xy<double>;
using Ring = boost::geometry::model::ring<PlanePoint>;

/// In the parameter plane.
PlanePoint onFace(const BoundaryFace& face, const BoundaryEdge& edge, const EdgeUse& use, double parameter) {
    if (const auto plane = Handle(Geom_Plane)::DownCast(face.surface); !plane.IsNull()) {
        const gp_Pnt2d at = parametersAt(plane, edge.curve.at(parameter));
        return {at.X(), at.Y()};
    }
    const gp_Pnt2d at = edge.onFaces.at(use.side())->Value(parameter);
    return {at.X(), at.Y()};
}

/// Points along an edge as the loop uses it.
Ring curveOn(const BoundaryFace& face, const BoundaryEdge& edge, const EdgeUse& use) {
    constexpr int steps = 8; // in every interval of a curve
    Ring points;
    for (const double parameter : parametersOf(edge.curve, steps))
        points.push_back(onFace(face, edge, use, parameter));
    if (!use.forwards) std::ranges::reverse(points);
    return points;
}

/// Edges begin where the one before ends, but for the tolerance of the vertex: if that is small beside the
/// first step, the two are one point.
void append(const Ring& points, Ring& ring) {
    constexpr double smallGap = 0.05;
    if (!ring.empty()) {
        const double gap = boost::geometry::distance(ring.back(), points.front());
        const double step = boost::geometry::distance(ring[ring.size() - 2], ring.back());
        if (gap < smallGap * step) ring.pop_back();
    }
    ring.insert(ring.end(), points.begin(), points.end());
}

} // namespace

bool outlineCrossesItself(const Boundary& boundary, std::size_t face) {
    return std::ranges::any_of(boundary.faces[face].loops, [&](const std::vector<EdgeUse>& loop) {
        Ring ring;
        for (const EdgeUse& use : loop)
            append(curveOn(boundary.faces[face], boundary.edges[use.edge], use), ring);
        append({ring.front()}, ring);
        return boost::geometry::intersects(ring);
    });
}

} // namespace qm
