/// \file Rows of the pruning program that keep borders smooth (docs/METHOD.md#pruning, smoothness).
#pragma once

#include "layout/borders.h"
#include "layout/layout.h"
#include "prune/grid_program.h"

#include <vector>

namespace qm {

/// Forbids removals from a layout that violate the smoothness criterion. Places where the layout itself
/// violates it may stay as they are.
class SmoothnessRows {
public:
    /// All references must outlive the object.
    /// \param grids  gets the rows
    SmoothnessRows(const PrunedMesh& pruned, const Layout& layout, const Smoothness& smoothness,
                   GridProgram& grids);

    /// Whether a border that leaves an extraordinary vertex must stay, because without it its two neighbours
    /// would form one border with a sharp turn.
    /// \param before, after  the neighbouring borders, each with one quad between it and `leaving`
    [[nodiscard]] bool mustStay(HalfedgeId before, HalfedgeId leaving, HalfedgeId after) const;

    /// Adds rows that leave the corners at an extraordinary vertex their room, see `roomAt`.
    void keepRoom(VertexId vertex);

    /// Adds rows that keep a track as long as the border exists on which it ends, if that border turns there.
    void keepEnds();

private:
    void keepEnd(HalfedgeId arriving);
    [[nodiscard]] ArcId arcAt(HalfedgeId halfedge) const;

    const QuadMesh& mesh_;
    const std::vector<double>& dihedralAngles_; ///< by edge, radians
    Smoothness smoothness_;
    GridProgram& grids_;
    std::vector<Track> tracks_; ///< of the layout, transversals apart
    Borders borders_;
};

} // namespace qm
