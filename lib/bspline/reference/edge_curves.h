/// \file Curves above edges that their ends alone decide (docs/METHOD.md#reference).
#pragma once

#include "bspline/network/vertex_rules.h"
#include "bspline/reference/mesh_lattice.h"
#include "mesh/quad_mesh.h"

#include <array>
#include <vector>

namespace qm {

/// Cubics between the ends of edges: straight but for what the tangent planes, or the directions of creases,
/// ask for at either end. The derivatives there are as long as the edge, so nothing overshoots however uneven
/// the edges around are.
class EdgeCurves {
public:
    /// \param lattice  the limit surface; its normals at vertices count up to their sign, as it may be folded
    /// \param sharp  by edge
    /// All must outlive this.
    EdgeCurves(const MeshLattice& lattice, const std::vector<VertexRule>& rules,
               const std::vector<bool>& sharp);

    /// Bezier points, from the halfedge's beginning to its end.
    [[nodiscard]] std::array<Point, 4> above(HalfedgeId halfedge) const;

private:
    [[nodiscard]] Point begin(HalfedgeId halfedge) const;
    [[nodiscard]] Point chord(HalfedgeId halfedge) const;
    [[nodiscard]] Point derivative(HalfedgeId leaving) const;
    [[nodiscard]] Point normalBeside(HalfedgeId leaving) const;
    [[nodiscard]] Point normalIn(HalfedgeId leaving) const;

    const MeshLattice& lattice_;
    const std::vector<VertexRule>& rules_;
    const std::vector<bool>& sharp_;
};

} // namespace qm
