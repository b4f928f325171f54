/// \file Connected quads that lie in one plane, whatever they stand for.
#pragma once

#include "bspline/reference/planes/plane_parts.h"
#include "mesh/quad_mesh.h"

#include <vector>

namespace qm {

/// The shape of a quad, as far as planes need it.
struct FlatQuad {
    Point normal{0, 0, 0}; ///< in the middle; zero if there is none
    double area = 0;
};

/// Parts grow over edges that are no creases, as long as all vertices lie in one plane, and no quad is turned
/// over. They begin where the mesh is flattest, and a part that turns out too thick is not tried again from
/// its other quads, so little is grown over twice.
/// \param isCrease  by edge, and the boundary
/// \param quads     by face
/// \param flatness  largest distance of vertices from the plane of their part
/// \return parts of one quad and more
[[nodiscard]] PlaneParts grownPlaneParts(const QuadMesh& mesh, const std::vector<bool>& isCrease,
                                         const std::vector<FlatQuad>& quads, double flatness, unsigned jobs);

} // namespace qm
