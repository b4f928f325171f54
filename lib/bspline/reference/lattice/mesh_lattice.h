/// \file Points on a lattice over all quads of a mesh, and their Catmull-Clark subdivision.
#pragma once

#include "base/at.h"
#include "bspline/network/vertex_rules.h"
#include "bspline/reference/lattice/lattice_numbers.h"
#include "bspline/splines/eigen_point.h"
#include "mesh/quad_mesh.h"

#include <cstddef>
#include <vector>

namespace qm {

/// A point for every number of a `LatticeNumbers`.
class MeshLattice {
public:
    /// A lattice of the vertices alone.
    /// \param points  by vertex
    MeshLattice(const QuadMesh& mesh, const std::vector<Point>& points);

    [[nodiscard]] int squares() const { return numbers_.squares(); }
    [[nodiscard]] const LatticeNumbers& numbers() const { return numbers_; }
    [[nodiscard]] Point point(std::size_t number) const { return qm::point(points_[number]); }
    /// By its place in a halfedge's face, or in a face; see `LatticeNumbers`.
    [[nodiscard]] Point point(HalfedgeId side, int along, int depth) const {
        return point(numbers_(side, along, depth));
    }
    [[nodiscard]] Point point(FaceId face, int i, int j) const { return point(numbers_(face, i, j)); }
    /// All points of a face, row by row.
    [[nodiscard]] std::vector<Eigen::Vector3d> points(FaceId face) const;
    /// Of the polynomial through the points above an edge, at the beginning of a halfedge.
    [[nodiscard]] Point derivative(HalfedgeId leaving) const;
    void move(std::size_t number, const Point& to) { points_[number] = vector(to); }
    void move(VertexId vertex, const Point& to) { move(at(vertex), to); }
    /// Moves the points between the ends of a halfedge.
    /// \param to  (along) where to
    template <class PointAt> void moveEdge(HalfedgeId halfedge, const PointAt& to) {
        for (int k = 1; k < squares(); ++k)
            move(numbers_(halfedge, k, 0), to(k));
    }
    /// Moves the points inside a halfedge's face.
    /// \param to  (along, depth) where to
    template <class PointAt> void moveInside(HalfedgeId side, const PointAt& to) {
        for (int j = 1; j < squares(); ++j)
            for (int i = 1; i < squares(); ++i)
                move(numbers_(side, i, j), to(i, j));
    }
    /// \param to  (column, row) where to
    template <class PointAt> void moveInside(FaceId face, const PointAt& to) {
        moveInside(numbers_.mesh().halfedge_handle(face), to);
    }

    /// One step of subdivision, which doubles the number of squares in each direction. Edges and faces can be
    /// processed independently; only vertices can be extraordinary. Sharp edges are subdivided as curves.
    [[nodiscard]] MeshLattice subdivided(const Sharpness& sharpness, unsigned jobs) const;
    /// Moves the points to their limits after infinitely many further steps.
    [[nodiscard]] MeshLattice limit(const Sharpness& sharpness, unsigned jobs) const;

private:
    struct Step;
    /// With points that are still to be set.
    explicit MeshLattice(const LatticeNumbers& numbers);
    [[nodiscard]] MeshLattice filtered(const Step& step, const Sharpness& sharpness, unsigned jobs) const;
    void filterVertex(const Step& step, VertexId vertex, const VertexRule& rule, MeshLattice& to) const;
    void filterEdge(const Step& step, EdgeId edge, bool sharp, MeshLattice& to) const;
    void filterFace(const Step& step, FaceId face, MeshLattice& to) const;

    LatticeNumbers numbers_;
    std::vector<Eigen::Vector3d> points_;
};

} // namespace qm
