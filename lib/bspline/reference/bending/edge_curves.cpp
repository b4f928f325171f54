#include "bspline/reference/bending/edge_curves.h"

#include "base/at.h"
#include "bspline/reference/lattice/bilinear_quad.h"

namespace qm {

EdgeCurves::EdgeCurves(const MeshLattice& lattice, const std::vector<VertexRule>& rules,
                       const std::vector<bool>& sharp)
    : lattice_(lattice), mesh_(lattice.numbers().mesh()), rules_(rules), sharp_(sharp) {}

std::array<Point, 4> EdgeCurves::above(HalfedgeId halfedge) const {
    const HalfedgeId back = mesh_.opposite_halfedge_handle(halfedge);
    const Point from = mesh_.point(mesh_.from_vertex_handle(halfedge));
    const Point to = mesh_.point(mesh_.to_vertex_handle(halfedge));
    return {from, from + derivative(halfedge) / 3, to + derivative(back) / 3, to};
}

/// At the beginning of a halfedge, into it.
Point EdgeCurves::derivative(HalfedgeId leaving) const {
    const VertexRule& rule = rules_[at(mesh_.from_vertex_handle(leaving))];
    const Point along = mesh_.calc_edge_vector(leaving);
    const double length = along.norm();
    const bool isSharp = sharp_[at(mesh_.edge_handle(leaving))];
    if (isSharp && rule.kind == VertexRule::Kind::crease) {
        const auto& [one, other] = rule.along;
        if (leaving != one && leaving != other) return along;
        const Point before = mesh_.calc_edge_vector(leaving == one ? other : one);
        // Of the parabola through the three vertices, by the lengths of both edges.
        return length * unit(unit(along) * before.norm() - unit(before) * length);
    }
    if (isSharp && rule.kind == VertexRule::Kind::corner) return along;
    const Point normal = normalBeside(leaving);
    return length * unit(along - normal * (along | normal));
}

/// Of the surface at the beginning of a halfedge, between the sharp edges on either side of it.
Point EdgeCurves::normalBeside(HalfedgeId leaving) const {
    const auto isSharp = [&](HalfedgeId halfedge) { return sharp_[at(mesh_.edge_handle(halfedge))]; };
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

/// Of the surface above a halfedge's face, at the halfedge's beginning: on the side that the quad shows.
Point EdgeCurves::normalIn(HalfedgeId leaving) const {
    const LatticeNumbers& numbers = lattice_.numbers();
    std::array<Point, 4> corners;
    HalfedgeId side = leaving;
    for (Point& corner : corners) {
        corner = mesh_.point(mesh_.from_vertex_handle(side));
        side = mesh_.next_halfedge_handle(side);
    }
    const Point ofQuad = BilinearQuad(corners).normal();
    const Point normal = unit((lattice_.point(numbers(leaving, 1, 0)) - corners[0]) %
                              (lattice_.point(numbers(leaving, 0, 1)) - corners[0]));
    if (normal.sqrnorm() == 0) return ofQuad;
    return (normal | ofQuad) < 0 ? -normal : normal;
}

} // namespace qm
