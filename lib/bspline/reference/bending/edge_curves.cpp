#include "bspline/reference/bending/edge_curves.h"

#include "base/at.h"
#include "bspline/reference/lattice/bilinear_quad.h"

namespace qm {

EdgeCurves::EdgeCurves(const MeshLattice& lattice, const std::vector<VertexRule>& rules,
                       const std::vector<bool>& sharp)
    : lattice_(lattice), rules_(rules), sharp_(sharp) {}

std::array<Point, 4> EdgeCurves::above(HalfedgeId halfedge) const {
    const QuadMesh& mesh = lattice_.numbers().mesh();
    const HalfedgeId back = mesh.opposite_halfedge_handle(halfedge);
    const Point from = begin(halfedge);
    const Point to = begin(back);
    return {from, from + derivative(halfedge) / 3, to + derivative(back) / 3, to};
}

Point EdgeCurves::begin(HalfedgeId halfedge) const {
    return lattice_.point(at(lattice_.numbers().mesh().from_vertex_handle(halfedge)));
}

Point EdgeCurves::chord(HalfedgeId halfedge) const {
    return begin(lattice_.numbers().mesh().opposite_halfedge_handle(halfedge)) - begin(halfedge);
}

/// At the beginning of a halfedge, into it.
Point EdgeCurves::derivative(HalfedgeId leaving) const {
    const QuadMesh& mesh = lattice_.numbers().mesh();
    const VertexRule& rule = rules_[at(mesh.from_vertex_handle(leaving))];
    const Point along = chord(leaving);
    const double length = along.norm();
    const bool isSharp = sharp_[at(mesh.edge_handle(leaving))];
    if (isSharp && rule.kind == VertexRule::Kind::crease) {
        const auto& [one, other] = rule.along;
        if (leaving != one && leaving != other) return along;
        const Point before = chord(leaving == one ? other : one);
        // Of the parabola through the three vertices, by the lengths of both edges.
        return length * unit(unit(along) * before.norm() - unit(before) * length);
    }
    if (isSharp && rule.kind == VertexRule::Kind::corner) return along;
    const Point normal = normalBeside(leaving);
    return length * unit(along - normal * (along | normal));
}

/// Of the surface at the beginning of a halfedge, between the sharp edges on either side of it.
Point EdgeCurves::normalBeside(HalfedgeId leaving) const {
    const QuadMesh& mesh = lattice_.numbers().mesh();
    const auto isSharp = [&](HalfedgeId halfedge) { return sharp_[at(mesh.edge_handle(halfedge))]; };
    Point sum(0, 0, 0);
    HalfedgeId halfedge = leaving; // the boundary is sharp
    do {
        sum += normalIn(halfedge);
        halfedge = mesh.ccw_rotated_halfedge_handle(halfedge);
    } while (!isSharp(halfedge) && halfedge != leaving);
    if (halfedge == leaving) return unit(sum);
    for (halfedge = leaving; !isSharp(halfedge);) {
        halfedge = mesh.cw_rotated_halfedge_handle(halfedge);
        sum += normalIn(halfedge);
    }
    return unit(sum);
}

/// Of the surface above a halfedge's face, at the halfedge's beginning: on the side that the quad shows.
Point EdgeCurves::normalIn(HalfedgeId leaving) const {
    const LatticeNumbers& numbers = lattice_.numbers();
    const QuadMesh& mesh = numbers.mesh();
    std::array<Point, 4> corners;
    HalfedgeId side = leaving;
    for (Point& corner : corners) {
        corner = begin(side);
        side = mesh.next_halfedge_handle(side);
    }
    const Point ofQuad = BilinearQuad(corners).normal();
    const Point normal = unit((lattice_.point(numbers(leaving, 1, 0)) - corners[0]) %
                              (lattice_.point(numbers(leaving, 0, 1)) - corners[0]));
    if (normal.sqrnorm() == 0) return ofQuad;
    return (normal | ofQuad) < 0 ? -normal : normal;
}

} // namespace qm
