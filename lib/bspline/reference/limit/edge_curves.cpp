#include "bspline/reference/limit/edge_curves.h"

#include "base/at.h"
#include "bspline/splines/evaluate.h"
#include "mesh/quad_geometry.h"

namespace qm {

std::array<Point, 4> EdgeCurves::above(HalfedgeId halfedge) const {
    const HalfedgeId back = mesh_.opposite_halfedge_handle(halfedge);
    const Point from = mesh_.point(mesh_.from_vertex_handle(halfedge));
    const Point to = mesh_.point(mesh_.to_vertex_handle(halfedge));
    return {from, from + derivative(halfedge) / 3, to + derivative(back) / 3, to};
}

/// At the beginning of a halfedge, into it, as long as the edge.
Point EdgeCurves::derivative(HalfedgeId leaving) const {
    const Point along = alongSurface(leaving);
    return corners_ == nullptr ? along : along.norm() * unit(corners_->within(leaving, along));
}

Point EdgeCurves::alongSurface(HalfedgeId leaving) const {
    const VertexRule& rule = sharpness_.rules[at(mesh_.from_vertex_handle(leaving))];
    const Point along = mesh_.calc_edge_vector(leaving);
    const double length = along.norm();
    const bool isSharp = sharpness_.edges[at(mesh_.edge_handle(leaving))];
    if (isSharp && rule.kind == VertexRule::Kind::crease) {
        const HalfedgeId onward = rule.onward(leaving);
        if (!onward.is_valid()) return along;
        const Point before = mesh_.calc_edge_vector(onward);
        // Of the parabola through the three vertices, by the lengths of both edges.
        return length * unit(unit(along) * before.norm() - unit(before) * length);
    }
    if (isSharp && rule.kind == VertexRule::Kind::corner) return along;
    const Point normal = normalBeside(leaving);
    return length * unit(along - normal * (along | normal));
}

/// At the beginning of a halfedge, of the faces between the sharp edges on either side of it.
Point EdgeCurves::normalBeside(HalfedgeId leaving) const {
    const auto isSharp = [&](HalfedgeId halfedge) {
        return sharpness_.edges[at(mesh_.edge_handle(halfedge))];
    };
    Point sum(0, 0, 0);
    HalfedgeId halfedge = leaving; // the boundary is sharp
    do {
        sum += normalIn(halfedge);
        halfedge = mesh_.ccw_rotated_halfedge_handle(halfedge);
    } while (!isSharp(halfedge) && halfedge != leaving);
    if (halfedge == leaving) return unit(sum);
    for (halfedge = leaving; !isSharp(halfedge);) {
        halfedge = mesh_.cw_rotated_halfedge_handle(halfedge);
        sum += normalIn(halfedge);
    }
    return unit(sum);
}

/// Of a halfedge's face, at the halfedge's beginning, with the weight that makes the sum exact on spheres
/// (docs/METHOD.md#max-1999).
Point EdgeCurves::normalIn(HalfedgeId leaving) const {
    const Point along = mesh_.calc_edge_vector(leaving);
    const Point beside = -mesh_.calc_edge_vector(mesh_.prev_halfedge_handle(leaving));
    const double weight = along.sqrnorm() * beside.sqrnorm();
    if (!(weight > 0)) return {0, 0, 0};
    const Point normal = (along % beside) / weight;
    const Point ofFace = middleNormal(mesh_, mesh_.face_handle(leaving)).value_or(normal);
    return (normal | ofFace) < 0 ? -normal : normal;
}

} // namespace qm
