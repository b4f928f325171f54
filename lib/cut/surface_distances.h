/// \file Geodesic distances inside one sub-mesh, computed on a coarser mesh if that is large
/// (docs/METHOD.md#mesh-cut).
#pragma once

#include "base/at.h"
#include "base/ids.h"
#include "cut/geodesics.h"

#include <array>
#include <optional>
#include <vector>

namespace qm {

/// The vertices of a sub-mesh are divided into cells around some of them, the centres: every vertex belongs
/// to the centre that is the fewest edges away, and centres are more than a few edges apart. A quad with
/// corners in several cells ties their centres; a front over the centres is some hundred times as fast as one
/// over the vertices. The distance of a vertex is that of its own or a neighbouring centre, plus a straight
/// line from there. The error is a few per cent of a cell's width for every cell on the way, which hardly
/// moves a cut, as it runs about half way between its terminals. In a small sub-mesh every vertex is a cell
/// of its own, and distances are those of the front.
class SurfaceDistances {
public:
    /// \param labels  sub-mesh of every vertex; may change between calls. Both must outlive the object.
    SurfaceDistances(const QuadMesh& mesh, const std::vector<SubMeshId>& labels);

    /// Prepares for another sub-mesh, in little more than linear time in its size.
    /// \param vertices  all vertices of one sub-mesh, ascending
    void prepare(const std::vector<VertexId>& vertices);

    /// The same with cells of any radius.
    /// \param radius  in edges; 0 if every vertex is to be a cell
    void prepare(const std::vector<VertexId>& vertices, int radius);

    /// The distances from the source to some vertices of its sub-mesh, in their order; infinity for vertices
    /// that cannot be reached inside the sub-mesh.
    /// \pre all vertices belong to the sub-mesh prepared last
    [[nodiscard]] std::vector<double> between(VertexId source, const std::vector<VertexId>& targets);

private:
    /// Cells at the corners of a quad, around it; if there are fewer than four, the last one is repeated.
    using CellTie = std::array<int, 4>;

    void makeCells(const std::vector<VertexId>& vertices, int radius);
    void growCell(VertexId centre, int radius);
    [[nodiscard]] std::vector<CellTie> tiesOf(const std::vector<VertexId>& vertices) const;
    [[nodiscard]] std::optional<CellTie> tieOf(HalfedgeId halfedge) const;
    void findNeighbours(const std::vector<CellTie>& ties);
    [[nodiscard]] int& cellOf(VertexId vertex) { return cellOf_[at(vertex)]; }
    [[nodiscard]] double length(VertexId vertex, int cell) const;

    const QuadMesh& mesh_;
    const std::vector<SubMeshId>& labels_;
    std::vector<int> steps_;  ///< edges from every vertex to its centre
    std::vector<int> cellOf_; ///< of every vertex
    std::vector<VertexId> centres_;
    /// Of every cell, itself and its neighbours, ascending; of single vertices, itself.
    std::vector<std::vector<int>> around_;
    std::optional<Geodesics> front_;
};

} // namespace qm
