/// \file One normal for both sides of every smooth border.
#pragma once

#include "bspline/chains.h"
#include "bspline/corner_normals.h"
#include "bspline/line_derivatives.h"
#include "bspline/spline_curve.h"

#include <array>
#include <vector>

namespace qm {

/// Along every chain a normal that the patches on both sides are to have, continuously turning from one
/// vertex to the next. At a vertex it is the mean normal of the faces around, as far as the next sharp edges,
/// or, where borders meet, that of their curves; so all borders that meet in such a sector agree.
class NormalField {
public:
    NormalField(const QuadMesh& mesh, const Chains& chains, const LineDerivatives& lines);

    /// True where one chain passes and one ends: their curves' tangents alone say what the normal is.
    [[nodiscard]] bool isTJoint(VertexId vertex) const {
        return tJoints_[static_cast<std::size_t>(vertex.idx())];
    }

    [[nodiscard]] const CornerNormals& corners() const { return corners_; }

    /// Takes the normals where borders meet from the curves. \param curves  by chain, walked forwards
    void setCurves(const std::vector<SplineCurve>& curves);

    /// At a share of an edge's length from its beginning; zero on sharp edges and on the boundary.
    [[nodiscard]] Point at(const ChainPlace& place, double share) const;

    /// Planes, given by their normals, in which the tangent of a border's curve should lie where `halfedge`
    /// leaves a vertex: that of the sector there, or those of both if they differ. None where the mesh's edge
    /// is far from such a plane.
    [[nodiscard]] std::vector<Point> tangentPlanes(HalfedgeId halfedge) const;

private:
    struct OnEdge {
        std::array<Point, 2> normal{Point(0, 0, 0), Point(0, 0, 0)}; ///< at both ends
        std::array<Point, 2> slope{Point(0, 0, 0), Point(0, 0, 0)};
        bool smooth = false;
    };

    void findTJoints();
    void setEdges();

    const QuadMesh& mesh_;
    const Chains& chains_;
    const LineDerivatives& lines_;
    CornerNormals corners_;
    std::vector<bool> tJoints_;              ///< by vertex
    std::vector<std::vector<OnEdge>> edges_; ///< by chain and position, forwards
};

} // namespace qm
