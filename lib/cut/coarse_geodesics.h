/// \file Geodesic distances on a large sub-mesh, by way of a coarser mesh (docs/METHOD.md#mesh-cut).
#pragma once

#include "base/at.h"
#include "cut/geodesics.h"

#include <optional>

namespace qm {

/// The vertices of a sub-mesh fall into cells around some of them, the centres: each belongs to the centre
/// that is the fewest edges away, and centres are more than a few edges apart. A quad with corners in several
/// cells ties their centres; a front over these is some hundred times as fast as one over the vertices. A
/// vertex is as far as its own centre or one beside it, and from there on straight. The error is a few per
/// cent of a cell's width for every cell on the way: a cut, which follows distances about half way between
/// its terminals, hardly moves.
class CoarseGeodesics : public SurfaceDistances {
public:
    /// About so many cells are made, however large the sub-mesh.
    static constexpr double wantedCells = 5000;

    /// \param labels  sub-mesh of every vertex; may change between calls
    CoarseGeodesics(const QuadMesh& mesh, const std::vector<SubMeshId>& labels);

    /// Turns to another sub-mesh. Takes time linear in it.
    /// \param vertices  all of one sub-mesh
    void coarsen(const std::vector<VertexId>& vertices);

    /// \pre all are among the vertices that were coarsened last
    std::vector<double> between(VertexId source, const std::vector<VertexId>& targets) override;

private:
    using Tie = std::array<int, 4>; ///< cells around a quad, the last one repeated if there are fewer

    void makeCells(const std::vector<VertexId>& vertices);
    void growCell(VertexId centre, int radius);
    void addTies(VertexId vertex, std::vector<Tie>& ties) const;
    void findNeighbours(const std::vector<Tie>& ties);
    [[nodiscard]] int& cellOf(VertexId vertex) { return cellOf_[at(vertex)]; }
    [[nodiscard]] double length(VertexId vertex, int cell) const;

    const QuadMesh& mesh_;
    const std::vector<SubMeshId>& labels_;
    std::vector<int> steps_;  ///< edges from every vertex to its centre
    std::vector<int> cellOf_; ///< of every vertex
    std::vector<VertexId> centres_;
    std::vector<std::vector<int>> around_; ///< of every cell: itself and its neighbours, ascending
    std::vector<SubMeshId> onlyOne_;       ///< of every cell
    std::optional<Geodesics> front_;
};

} // namespace qm
