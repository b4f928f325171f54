/// \file Where the reference is smooth, where a curve runs sharply through a vertex, and where it has a
/// corner.
#pragma once

#include "layout/layout.h"
#include "mesh/quad_mesh.h"

#include <array>
#include <vector>

namespace qm {

/// What the surface does at a vertex.
struct VertexRule {
    enum class Kind {
        smooth, ///< no crease
        dart,   ///< smooth, one crease ends there
        crease, ///< a smooth curve of creases passes; others may end on it
        corner  ///< stays a corner; isolated vertices too
    };
    Kind kind = Kind::smooth;
    /// They leave the vertex: of a crease the two that its curve follows, of a dart the one that ends, twice.
    std::array<HalfedgeId, 2> along = {HalfedgeId(), HalfedgeId()};

    /// Of a curve of creases that passes the vertex along a halfedge which leaves it: the halfedge along
    /// which it leaves on the other side; invalid if there is no such curve.
    [[nodiscard]] HalfedgeId onward(HalfedgeId leaving) const {
        if (kind != Kind::crease) return HalfedgeId();
        return leaving == along[0] ? along[1] : leaving == along[1] ? along[0] : HalfedgeId();
    }
};

/// Where a surface is sharp: the rules of all vertices, and the edges that are creases or on the boundary.
/// What it refers to must outlive it.
struct Sharpness {
    const std::vector<VertexRule>& rules;
    const std::vector<bool>& edges;
};

/// Whether one smooth curve may follow two creases that leave a vertex: two or more quads lie on either side
/// between them, so that no quad alone has to fill a flat angle, and they turn by at most `cornerAngle`.
[[nodiscard]] bool isCurve(const QuadMesh& mesh, const std::array<HalfedgeId, 2>& creases);

/// Whether a curve of creases passes a vertex with two quads on either side, or on the only one.
[[nodiscard]] bool isRegularCrease(const QuadMesh& mesh, VertexId vertex, const VertexRule& rule);

/// The rule of every vertex. With two or more creases (the mesh boundary is one) it is a corner, unless
/// - a side of a segment passes straight through along two creases: there the patch has only one tangent. If
///   several pass, the straightest is the curve, the first of them where they are equal; or
/// - there are just two creases, and a curve may follow both. Beyond the boundary there are no quads to
///   count, so a boundary vertex of a single quad is a corner.
///
/// OpenSubdiv and the subdivision literature count creases alone: they have no rule for a crease that ends on
/// another one, which is what tracks of a layout do.
/// \param sharp  by edge: creases, and the mesh boundary
[[nodiscard]] std::vector<VertexRule> vertexRules(const QuadMesh& mesh, const Layout& layout,
                                                  const std::vector<bool>& sharp);

/// Radians. Regular polygons of up to five sides keep their corners, those of more are taken as round.
constexpr double cornerAngle = 1.2;

} // namespace qm
