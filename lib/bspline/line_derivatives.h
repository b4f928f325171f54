/// \file Derivatives of the surface that a mesh stands for, estimated along its lines.
#pragma once

#include "mesh/quad_mesh.h"

#include <optional>
#include <vector>

namespace qm {

/// Takes every edge as a step of length one. A line goes straight on over regular vertices, along the
/// boundary too where it turns by at most rho; it ends at extraordinary vertices and where it meets a sharp
/// edge. Whoever asks from either side of a vertex that a line passes gets the same derivative, or, where the
/// steps on both sides differ much, at least the same direction.
class LineDerivatives {
public:
    /// \param dihedralAngles  by edge index, radians \param rho  edges above it are sharp
    LineDerivatives(const QuadMesh& mesh, const std::vector<double>& dihedralAngles, double rho);

    /// Derivative along the line at the vertex that `halfedge` leaves: a central difference if the line
    /// passes the vertex, else a one-sided one, turned into the tangent plane of its smooth surroundings.
    [[nodiscard]] Point tangent(HalfedgeId halfedge) const;

    /// Mixed second derivative at the vertex that `halfedge` leaves, along it and along the edge to its left.
    [[nodiscard]] Point twist(HalfedgeId halfedge) const;

    [[nodiscard]] bool isSmooth(EdgeId edge) const;
    /// Smooth, and with faces on both sides.
    [[nodiscard]] bool isSmoothInside(EdgeId edge) const {
        return !mesh_.is_boundary(edge) && isSmooth(edge);
    }

    /// The mean normal, around the vertex that `halfedge` leaves, of all faces from its left to the next
    /// sharp edges; zero where there is none.
    [[nodiscard]] Point normalOnLeft(HalfedgeId halfedge) const;

private:
    [[nodiscard]] std::optional<HalfedgeId> goOn(HalfedgeId halfedge) const;
    [[nodiscard]] Point oneSided(HalfedgeId halfedge) const;
    [[nodiscard]] bool bendsSharply(HalfedgeId halfedge, const Point& forwards, const Point& backwards) const;
    [[nodiscard]] Point inTangentPlane(HalfedgeId halfedge, const Point& tangent) const;
    [[nodiscard]] const Point& end(HalfedgeId halfedge) const;
    [[nodiscard]] const Point& start(HalfedgeId halfedge) const;
    [[nodiscard]] HalfedgeId opposite(HalfedgeId halfedge) const;

    const QuadMesh& mesh_;
    std::vector<bool> smooth_; ///< by edge index
    double rho_;
};

} // namespace qm
