#include "prune/smoothness_rows.h"

#include "base/at.h"
#include "mesh/topology.h"
#include "prune/border_angles.h"
#include "prune/vertex_room.h"

#include <algorithm>

namespace qm {

SmoothnessRows::SmoothnessRows(const PrunedMesh& pruned, const Layout& layout, const Smoothness& smoothness,
                               GridProgram& grids)
    : mesh_(pruned.mesh), dihedralAngles_(pruned.dihedralAngles), smoothness_(smoothness), grids_(grids),
      tracks_(properTracks(layout)), borders_(mesh_, tracks_) {}

ArcId SmoothnessRows::arcAt(HalfedgeId halfedge) const {
    return grids_.arcOf[at(mesh_.edge_handle(halfedge))];
}

bool SmoothnessRows::mustStay(HalfedgeId before, HalfedgeId leaving, HalfedgeId after) const {
    return borders_.isBorder(leaving) && arcAt(leaving).valid() &&
           turnBetween(mesh_, before, after) > smoothness_.maxTurn;
}

void SmoothnessRows::keepRoom(VertexId vertex) {
    for (const RoomSector& sector : roomAt(mesh_, dihedralAngles_, vertex, smoothness_.minCorner)) {
        GridProgram::Terms terms;
        std::size_t missing = 0;
        for (const HalfedgeId edge : sector.edges) {
            terms.emplace_back(arcAt(edge), 1);
            missing += borders_.isBorder(edge) ? 0 : 1;
        }
        missing = std::max(missing, sector.maxMissing);
        if (missing < terms.size()) grids_.addRow(terms, static_cast<double>(terms.size() - missing));
    }
}

void SmoothnessRows::keepEnds() {
    for (const Track& track : tracks_) {
        keepEnd(track.halfedges.back());
        keepEnd(mesh_.opposite_halfedge_handle(track.halfedges.front()));
    }
}

void SmoothnessRows::keepEnd(HalfedgeId arriving) {
    if (!continuesStraight(mesh_, mesh_.to_vertex_handle(arriving))) return;
    const auto [left, right] = crossingAt(mesh_, arriving);
    if (!arcAt(arriving).valid() || !arcAt(left).valid() || !arcAt(right).valid()) return;
    if (turnBetween(mesh_, left, right) > smoothness_.maxTurn)
        grids_.addRow({{arcAt(arriving), 1}, {arcAt(left), -1}, {arcAt(right), -1}}, -1);
}

} // namespace qm
