/// \file What must stay so that borders stay smooth, as rows of the pruning program
/// (docs/METHOD.md#pruning, smoothness).
#pragma once

#include "layout/layout.h"
#include "prune/grid_program.h"

#include <vector>

namespace qm {

/// Finds what a removal from a layout would spoil. What the layout spoils already may stay so.
class SmoothnessRows {
public:
    /// \param arcOf           of every edge; invalid where no line runs
    /// \param dihedralAngles  by edge, radians
    /// All references must outlive the object.
    SmoothnessRows(const QuadMesh& mesh, const std::vector<ArcId>& arcOf,
                   const std::vector<double>& dihedralAngles, const Layout& layout,
                   const Smoothness& smoothness);

    /// Whether a border that leaves an extraordinary vertex must stay, because its neighbours would become
    /// one border with a sharp turn.
    /// \param before, after  its neighbours, with a quad between it and each of them
    [[nodiscard]] bool mustStay(HalfedgeId before, HalfedgeId leaving, HalfedgeId after) const;

    /// Corners at an extraordinary vertex keep their room, see `roomAt`.
    void keepRoom(VertexId vertex, GridProgram& grids) const;

    /// Where a track of the layout ends on another border that turns there, the track stays as long as that
    /// border does.
    void keepEnds(GridProgram& grids) const;

private:
    void keepEnd(HalfedgeId arriving, GridProgram& grids) const;
    [[nodiscard]] bool isInLayout(HalfedgeId halfedge) const;
    [[nodiscard]] ArcId arcAt(HalfedgeId halfedge) const;

    const QuadMesh& mesh_;
    const std::vector<ArcId>& arcOf_;
    const std::vector<double>& dihedralAngles_;
    const Layout& layout_;
    Smoothness smoothness_;
    std::vector<bool> inLayout_; ///< of every edge: on a track that is no transversal
};

} // namespace qm
