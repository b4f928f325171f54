/// \file What one step of Catmull-Clark subdivision, and the limit of all steps, make of a vertex.
#pragma once

#include "bspline/network/vertex_rules.h"
#include "mesh/quad_mesh.h"

#include <vector>

namespace qm {

/// A vertex as a weighted mean of itself and the vertices around it.
struct VertexStencil {
    struct Term {
        HalfedgeId halfedge;   ///< leaves the vertex
        bool diagonal = false; ///< false: the vertex it points to; true: the one opposite in its face
        double weight = 0;
    };
    double own = 1;
    std::vector<Term> around;
};

/// Catmull and Clark's rule for a vertex (docs/METHOD.md#catmull-1978), that of a cubic spline curve along
/// creases (docs/METHOD.md#derose-1998), or the vertex itself at a corner.
/// \param stencil  to write to; its memory is used again
void subdivisionStencil(const QuadMesh& mesh, VertexId vertex, const VertexRule& rule,
                        VertexStencil& stencil);

/// The limit: the left eigenvector of one step around the vertex for the eigenvalue 1
/// (docs/METHOD.md#halstead-1993). At a dart it is not the smooth one, as is often assumed, because the
/// crease is subdivided otherwise than other edges.
void limitStencil(const QuadMesh& mesh, VertexId vertex, const VertexRule& rule, VertexStencil& stencil);

} // namespace qm
