/// \file What meets at a vertex of the layout: patches, smooth borders and creases, and the angles that they
/// should have in the tangent plane (docs/METHOD.md#smooth-fit).
#pragma once

#include "bspline/network/borders.h"
#include "bspline/network/vertex_rules.h"
#include "mesh/quad_mesh.h"

#include <vector>

namespace qm {

/// The border edges around a vertex, counter-clockwise, as halfedges that leave it. Between one and the next
/// lie `faces` of one patch: 1 is a corner of the patch, 2 a side that passes straight through. On the mesh
/// boundary the last one has none.
struct VertexFan {
    std::vector<HalfedgeId> borders;
    std::vector<int> faces;
    std::vector<bool> isCrease;
    bool isClosed = true; ///< the vertex is interior
};

/// \param vertex  on the border of a patch
[[nodiscard]] VertexFan vertexFan(const QuadMesh& mesh, const BorderMarks& marks, VertexId vertex);

/// For every border of a fan that is smooth: the number lambda for which the derivatives into the two patches
/// beside it must sum up to lambda times the derivative along it, at the vertex. Creases have 0.
[[nodiscard]] std::vector<double> tangentRatios(const QuadMesh& mesh, const VertexFan& fan,
                                                const VertexRule& rule);

} // namespace qm
