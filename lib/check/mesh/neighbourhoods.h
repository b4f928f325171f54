/// \file The checker's own view of a mesh: every vertex with its neighbours in counter-clockwise order.
///
/// Built from nothing but the list of faces, so that no adjacency of the other modules is taken on trust.
#pragma once

#include "base/at.h"

#include <array>
#include <span>
#include <vector>

namespace qm::check {

/// A quad mesh as the file lists it.
struct CheckedMesh {
    std::vector<std::array<double, 3>> points;
    std::vector<std::array<int, 4>> quads; ///< counter-clockwise, in file order
};

/// The points and faces of a mesh of another type, in their order.
/// \param mesh  of quads, with the functions of OpenMesh
template <class Mesh> [[nodiscard]] CheckedMesh checkedMesh(const Mesh& mesh) {
    CheckedMesh result;
    for (const auto vertex : mesh.vertices())
        result.points.push_back({mesh.point(vertex)[0], mesh.point(vertex)[1], mesh.point(vertex)[2]});
    for (const auto face : mesh.faces()) {
        auto corner = result.quads.emplace_back().begin();
        for (const auto vertex : mesh.fv_range(face))
            *corner++ = vertex.idx();
    }
    return result;
}

/// A *step* is one vertex's view of one of its edges: it leads from that vertex to the neighbour across.
/// The steps of a vertex are consecutive numbers, counter-clockwise; those of a boundary vertex begin and
/// end on the boundary. An edge is two steps, each the other's `back`.
class Neighbourhoods {
public:
    /// Linear in the mesh.
    /// \throw Error  if a face is no quad of four different vertices, or the faces around some vertex are no
    /// single consistently oriented fan
    explicit Neighbourhoods(const CheckedMesh& mesh);

    [[nodiscard]] int vertices() const { return static_cast<int>(closed_.size()); }
    [[nodiscard]] int faces() const { return faces_; }
    [[nodiscard]] int edges() const { return edges_; }
    [[nodiscard]] int steps() const { return static_cast<int>(to_.size()); }

    [[nodiscard]] int valence(int vertex) const { return first_[at(vertex) + 1] - first_[at(vertex)]; }
    [[nodiscard]] int firstStep(int vertex) const { return first_[at(vertex)]; }
    [[nodiscard]] bool interior(int vertex) const { return closed_[at(vertex)] && valence(vertex) > 0; }
    /// Interior with four edges, or on the boundary with one or two faces; a vertex of no face counts too.
    [[nodiscard]] bool regular(int vertex) const;
    /// True where a mesh line goes on: interior with four edges.
    [[nodiscard]] bool passable(int vertex) const { return interior(vertex) && valence(vertex) == 4; }

    [[nodiscard]] int from(int step) const { return to_[at(back_[at(step)])]; }
    [[nodiscard]] int to(int step) const { return to_[at(step)]; }
    [[nodiscard]] int back(int step) const { return back_[at(step)]; }
    [[nodiscard]] int edge(int step) const { return edge_[at(step)]; }
    /// The face to the left; -1 where the mesh ends.
    [[nodiscard]] int leftFace(int step) const { return left_[at(step)]; }
    [[nodiscard]] bool boundary(int step) const { return leftFace(step) < 0 || leftFace(back(step)) < 0; }

    /// The step from one vertex to another; -1 if no edge joins them.
    [[nodiscard]] int stepBetween(int fromVertex, int toVertex) const;
    /// The step that goes on straight across the vertex that `step` leads to, which must be passable.
    [[nodiscard]] int straightOn(int step) const { return turn(back(step), 2); }
    /// The step `quarters` places counter-clockwise of `step` around its own vertex, which must be passable.
    [[nodiscard]] int turn(int step, int quarters) const;

private:
    struct Corner {
        int next;     ///< the vertex after the corner, around its face
        int previous; ///< the vertex before it
        int side;     ///< 4 * face + the corner's rank in it: its step to `next` is that side of the face
    };
    void addFan(int vertex, std::span<Corner> corners);
    /// Of every corner of a vertex: the next one counter-clockwise, beyond their common edge; -1 if there is
    /// none.
    /// \param corners  ascending by `next`
    [[nodiscard]] static std::vector<int> followingCorners(int vertex, std::span<const Corner> corners);
    void pairSteps(const CheckedMesh& mesh);

    int faces_ = 0;
    int edges_ = 0;
    std::vector<int> first_; ///< per vertex, and the end
    std::vector<char> closed_;
    std::vector<int> to_, back_, edge_, left_; ///< per step
    std::vector<int> stepOfSide_;              ///< by 4 * face + rank of the side's first corner
};

} // namespace qm::check
