/// \file Numbers for the points of a lattice over all quads of a mesh.
#pragma once

#include "layout/layout.h"
#include "mesh/quad_mesh.h"

#include <cstddef>
#include <vector>

namespace qm {

/// A lattice of n x n squares over every quad. Quads that meet share the points on their common edge, so no
/// two values of one point can differ. The vertices come first, then what lies inside the edges, then what
/// lies inside the faces. The mesh must stay where it is.
class LatticeNumbers {
public:
    LatticeNumbers(const QuadMesh& mesh, int squares) : mesh_(&mesh), squares_(squares) {}

    [[nodiscard]] const QuadMesh& mesh() const { return *mesh_; }
    [[nodiscard]] int squares() const { return squares_; }
    [[nodiscard]] std::size_t count() const;
    /// The point of a halfedge's face that is `along` squares from the halfedge's beginning and `depth`
    /// squares away from it; for a boundary halfedge only depth 0.
    [[nodiscard]] std::size_t operator()(HalfedgeId halfedge, int along, int depth) const;
    /// All points of a segment, in the order of `ReferenceGrid::points` with as many steps as squares.
    [[nodiscard]] std::vector<std::size_t> ofSegment(const Segment& segment) const;

private:
    [[nodiscard]] std::size_t onEdge(HalfedgeId halfedge, int along) const;

    const QuadMesh* mesh_;
    int squares_;
};

} // namespace qm
