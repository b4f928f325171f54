/// \file The weights of one step of Catmull-Clark subdivision at a vertex, and of its limit.
#pragma once

#include "bspline/network/vertex_rules.h"
#include "mesh/quad_mesh.h"

#include <vector>

namespace qm {

/// A vertex as a weighted mean of itself and the vertices around it.
struct VertexStencil {
    struct Term {
        HalfedgeId halfedge;   ///< leaves the vertex
        bool diagonal = false; ///< false: the vertex that it points to; true: the opposite vertex of its face
        double weight = 0;
    };
    double own = 1;
    std::vector<Term> around;
};

/// Catmull and Clark's rule for a vertex (docs/METHOD.md#catmull-1978), that of a cubic spline curve along
/// creases (docs/METHOD.md#derose-1998), or the vertex itself at a corner.
[[nodiscard]] VertexStencil subdivisionStencil(const QuadMesh& mesh, VertexId vertex, const VertexRule& rule);

/// The limit position, by the left eigenvector of one step around the vertex for the eigenvalue 1
/// (docs/METHOD.md#halstead-1993). At a dart it differs from the one of a smooth vertex, which is often used
/// instead, because the crease is subdivided differently from other edges.
[[nodiscard]] VertexStencil limitStencil(const QuadMesh& mesh, VertexId vertex, const VertexRule& rule);

} // namespace qm
