/// \file Curves above edges, determined by the two ends alone (docs/METHOD.md#reference).
#pragma once

#include "bspline/network/vertex_rules.h"
#include "bspline/reference/lattice/mesh_lattice.h"
#include "mesh/quad_mesh.h"

#include <array>
#include <vector>

namespace qm {

/// Cubics between the ends of edges, as straight as the tangent planes or crease directions at the ends
/// allow. The derivatives there are as long as the edge, so that no curve overshoots, however uneven the
/// edges around it are.
class EdgeCurves {
public:
    /// The arguments must outlive the curves.
    /// \param lattice  the surface through the vertices, which may be folded, so only the axes of its normals
    /// there are used
    /// \param sharp    by edge
    EdgeCurves(const MeshLattice& lattice, const std::vector<VertexRule>& rules,
               const std::vector<bool>& sharp);

    /// The Bezier points above a halfedge, from its beginning to its end.
    [[nodiscard]] std::array<Point, 4> above(HalfedgeId halfedge) const;

private:
    [[nodiscard]] Point derivative(HalfedgeId leaving) const;
    [[nodiscard]] Point normalBeside(HalfedgeId leaving) const;
    [[nodiscard]] Point normalIn(HalfedgeId leaving) const;

    const MeshLattice& lattice_;
    const QuadMesh& mesh_;
    const std::vector<VertexRule>& rules_;
    const std::vector<bool>& sharp_;
};

} // namespace qm
