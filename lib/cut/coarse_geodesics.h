/// \file Geodesic distances on a large sub-mesh, computed on a coarser mesh (docs/METHOD.md#mesh-cut).
#pragma once

#include "base/at.h"
#include "base/ids.h"
#include "cut/cell_ties.h"
#include "cut/geodesics.h"
#include "cut/surface_distances.h"

#include <optional>

namespace qm {

/// The vertices of a sub-mesh are divided into cells around some of them, the centres: every vertex belongs
/// to the centre that is the fewest edges away, and centres are more than a few edges apart. A quad with
/// corners in several cells ties their centres; a front over the centres is some hundred times as fast as one
/// over the vertices. The distance of a vertex is that of its own or a neighbouring centre, plus a straight
/// line from there. The error is a few per cent of a cell's width for every cell on the way, which hardly
/// moves a cut, as it runs about half way between its terminals.
class CoarseGeodesics : public SurfaceDistances {
public:
    /// About this many cells are made, however large the sub-mesh is.
    static constexpr double wantedCells = 5000;

    /// \param labels  sub-mesh of every vertex; may change between calls
    CoarseGeodesics(const QuadMesh& mesh, const std::vector<SubMeshId>& labels);

    /// Prepares for another sub-mesh, in time linear in its size.
    /// \param vertices  all vertices of one sub-mesh
    void coarsen(const std::vector<VertexId>& vertices);

    /// \pre all vertices belong to the sub-mesh coarsened last
    std::vector<double> between(VertexId source, const std::vector<VertexId>& targets) override;

private:
    void makeCells(const std::vector<VertexId>& vertices);
    void growCell(VertexId centre, int radius);
    void findNeighbours(const std::vector<CellTie>& ties);
    [[nodiscard]] int& cellOf(VertexId vertex) { return cellOf_[at(vertex)]; }
    [[nodiscard]] double length(VertexId vertex, int cell) const;

    const QuadMesh& mesh_;
    const std::vector<SubMeshId>& labels_;
    std::vector<int> steps_;  ///< edges from every vertex to its centre
    std::vector<int> cellOf_; ///< of every vertex
    std::vector<VertexId> centres_;
    std::vector<std::vector<int>> around_; ///< of every cell, itself and its neighbours, ascending
    std::optional<Geodesics> front_;
};

} // namespace qm
