/// \file Parts of a mesh that are plane (docs/METHOD.md#reference).
#pragma once

#include "base/at.h"
#include "bspline/reference/planes/plane.h"
#include "mesh/quad_mesh.h"

#include <vector>

namespace qm {

/// Connected quads in one plane.
struct PlaneParts {
    /// Of every part, the normal on the side of the quads' own; empty if no part has a quad.
    std::vector<Plane> planes;
    std::vector<int> ofFace; ///< by face: its part, or none

    static constexpr int none = -1;

    /// The part of the quad beside a halfedge; none on the boundary.
    [[nodiscard]] int beside(const QuadMesh& mesh, HalfedgeId side) const {
        return mesh.is_boundary(side) ? none : ofFace[at(mesh.face_handle(side))];
    }
};

/// The part whose quads surround a vertex without creases, or none.
[[nodiscard]] int partAround(const QuadMesh& mesh, const PlaneParts& parts, const std::vector<bool>& isCrease,
                             VertexId vertex);

/// The parts that are meant to be plane: with several vertices inside, or much wider than what continues
/// them. Facets of something round, whose quads were divided, are not among them. Linear in the mesh.
/// \param isCrease  by edge, and the boundary
/// \param flatness  largest distance of vertices from the plane of their part
[[nodiscard]] PlaneParts planeParts(const QuadMesh& mesh, const std::vector<bool>& isCrease, double flatness,
                                    unsigned jobs);

} // namespace qm
