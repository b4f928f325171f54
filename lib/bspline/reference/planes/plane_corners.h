/// \file Where tangent planes at vertices are those of plane parts (docs/METHOD.md#reference).
#pragma once

#include "bspline/network/vertex_rules.h"
#include "bspline/reference/lattice/mesh_lattice.h"
#include "bspline/reference/planes/plane_parts.h"

#include <vector>

namespace qm {

/// The plane parts that the surface around each vertex follows. Creases divide the quads around a vertex into
/// sectors; in every sector with a plane quad the surface is tangent to its plane. Where two parts meet in
/// one sector the surface is smooth between them, so neither has the vertex; nor does a part have vertices
/// whose lines would turn much to follow it, or quads with a corner that it has not.
class PlaneCorners {
public:
    /// The mesh of the lattice and the rules must outlive the corners.
    PlaneCorners(const MeshLattice& lattice, const Sharpness& sharpness, double flatness, unsigned jobs);

    /// Whether the mesh has no plane parts.
    [[nodiscard]] bool isEmpty() const { return parts_.planes.empty(); }
    /// The part that has a whole quad, or the one beside a halfedge; or none.
    [[nodiscard]] int partOf(FaceId face) const { return parts_.ofFace[at(face)]; }
    [[nodiscard]] int partBeside(HalfedgeId side) const { return parts_.beside(mesh_, side); }
    /// The part that the surface follows where the face of a halfedge has its corner at the halfedge's
    /// beginning, or none.
    [[nodiscard]] int partAtCorner(HalfedgeId leaving) const { return ofCorner_[at(leaving)]; }
    [[nodiscard]] const Plane& plane(int part) const { return parts_.planes[at(part)]; }
    /// Whether the surface follows a part anywhere around a vertex.
    [[nodiscard]] bool isBound(VertexId vertex) const;
    /// What is left of a derivative along a halfedge, at its beginning, in the planes that it has to lie in.
    [[nodiscard]] Point within(HalfedgeId leaving, const Point& derivative) const;

private:
    void findSectors(VertexId vertex, const std::vector<bool>& isCrease);
    void keepIfWhole(FaceId face);
    void release(VertexId vertex);
    [[nodiscard]] bool turnsMuch(const MeshLattice& lattice, VertexId vertex) const;
    /// The parts in whose planes the line along a halfedge has to lie at its beginning.
    [[nodiscard]] std::vector<int> partsOf(HalfedgeId leaving) const;

    const QuadMesh& mesh_;
    const std::vector<VertexRule>& rules_;
    PlaneParts parts_;
    std::vector<int> ofCorner_; ///< by halfedge
};

} // namespace qm
