/// \file Points on a lattice over all quads of a mesh, and Catmull-Clark subdivision on it.
#pragma once

#include "bspline/splines/eigen_point.h"
#include "bspline/network/vertex_rules.h"
#include "mesh/quad_mesh.h"

#include <cstddef>
#include <vector>

namespace qm {

/// A lattice of n x n squares over every quad. Quads that meet share the points on their common edge, so no
/// two values of one point can differ.
class MeshLattice {
public:
    /// With the vertices alone. \param points  by vertex
    MeshLattice(const QuadMesh& mesh, const std::vector<Point>& points);

    [[nodiscard]] int squares() const { return squares_; }
    /// The point of a halfedge's face that is `along` squares from the halfedge's beginning and `depth`
    /// squares away from it; for a boundary halfedge only depth 0.
    [[nodiscard]] Point at(HalfedgeId halfedge, int along, int depth) const {
        return point(points_[number(halfedge, along, depth)]);
    }
    void move(VertexId vertex, const Point& to) {
        points_[static_cast<std::size_t>(vertex.idx())] = vector(to);
    }

    /// One step of subdivision: a lattice with twice as many squares each way. Every edge and every face is
    /// independent of the others, all that is extraordinary are the vertices.
    /// \param sharp  by edge: is subdivided as a curve
    [[nodiscard]] MeshLattice subdivided(const std::vector<VertexRule>& rules, const std::vector<bool>& sharp,
                                         unsigned jobs) const;
    /// Where the points end after all further steps.
    [[nodiscard]] MeshLattice limit(const std::vector<VertexRule>& rules, const std::vector<bool>& sharp,
                                    unsigned jobs) const;

private:
    struct Step;
    MeshLattice(const QuadMesh& mesh, int squares);
    [[nodiscard]] MeshLattice filtered(const Step& step, const std::vector<VertexRule>& rules,
                                       const std::vector<bool>& sharp, unsigned jobs) const;
    void filterVertex(const Step& step, VertexId vertex, const VertexRule& rule, MeshLattice& to) const;
    void filterEdge(const Step& step, EdgeId edge, bool sharp, MeshLattice& to) const;
    void filterFace(const Step& step, FaceId face, MeshLattice& to) const;
    [[nodiscard]] std::size_t number(HalfedgeId halfedge, int along, int depth) const;
    [[nodiscard]] std::size_t numberOnEdge(HalfedgeId halfedge, int along) const;

    const QuadMesh* mesh_;
    int squares_ = 1;
    std::vector<Eigen::Vector3d> points_; ///< of the vertices, then inside the edges, then inside the faces
};

} // namespace qm
