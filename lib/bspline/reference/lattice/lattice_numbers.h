/// \file Numbers for the points of a lattice over all quads of a mesh.
#pragma once

#include "layout/layout.h"
#include "mesh/quad_mesh.h"

#include <array>
#include <cstddef>
#include <vector>

namespace qm {

/// Numbers the points of a lattice of n x n squares over every quad. Neighbouring quads share the points on
/// their common edge, so the values there cannot differ. The vertices come first, then the points inside
/// edges, then those inside faces. The mesh must outlive the numbers.
class LatticeNumbers {
public:
    LatticeNumbers(const QuadMesh& mesh, int squares) : mesh_(&mesh), squares_(squares) {}

    [[nodiscard]] const QuadMesh& mesh() const { return *mesh_; }
    [[nodiscard]] int squares() const { return squares_; }
    [[nodiscard]] std::size_t count() const;
    /// The point of a halfedge's face that is `along` squares from the halfedge's beginning and `depth`
    /// squares away from the halfedge; for a boundary halfedge `depth` must be 0.
    [[nodiscard]] std::size_t operator()(HalfedgeId halfedge, int along, int depth) const;
    /// The point in column i and row j of a face.
    [[nodiscard]] std::size_t operator()(FaceId face, int i, int j) const {
        return (*this)(mesh_->halfedge_handle(face), i, j);
    }
    /// The vertices of a face, counter-clockwise from the one in column and row 0.
    [[nodiscard]] std::array<VertexId, 4> corners(FaceId face) const;
    /// All points of a segment in the order of `ReferenceGrid::points`.
    [[nodiscard]] std::vector<std::size_t> ofSegment(const Segment& segment) const;

private:
    [[nodiscard]] std::size_t onEdge(HalfedgeId halfedge, int along) const;

    const QuadMesh* mesh_;
    int squares_;
};

} // namespace qm
