/// \file The planes in which curves should meet.
#pragma once

#include "bspline/chains.h"
#include "bspline/line_derivatives.h"
#include "bspline/spline_curve.h"

#include <vector>

namespace qm {

/// Around a vertex where borders meet, between one sharp edge and the next, all patches should have one
/// normal: so the tangents of all curves that leave the vertex there should lie in one plane. It is the
/// mesh's until there are curves; then it is the one nearest to their tangents, which asks least of them.
class CornerNormals {
public:
    CornerNormals(const QuadMesh& mesh, const Chains& chains, const LineDerivatives& lines);

    /// \param curves  by chain, walked forwards
    void setCurves(const std::vector<SplineCurve>& curves);

    /// The unit normal of the sector on the left of a halfedge, at the vertex that it leaves; zero where
    /// there is none.
    [[nodiscard]] Point onLeft(HalfedgeId halfedge) const;

    /// Whether more than two curves meet in a sector beside a halfedge, at the vertex that it leaves: any two
    /// lie in a plane.
    [[nodiscard]] bool isShared(HalfedgeId halfedge) const;

private:
    /// The border halfedges that leave a vertex in a sector or at its ends, counter-clockwise, and all whose
    /// left is in it.
    struct Sector {
        std::vector<HalfedgeId> borders;
        std::vector<HalfedgeId> within;
    };
    void findSectors(HalfedgeId first);
    [[nodiscard]] Point tangent(HalfedgeId halfedge, const std::vector<SplineCurve>& curves) const;

    const QuadMesh& mesh_;
    const Chains& chains_;
    const LineDerivatives& lines_;
    std::vector<Sector> sectors_; ///< with three borders at least
    std::vector<bool> shared_;    ///< by halfedge: whether its left is in one of them
    std::vector<Point> normals_;  ///< by halfedge; zero if the mesh's counts
};

} // namespace qm
