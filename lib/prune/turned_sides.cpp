#include "prune/turned_sides.h"

#include "mesh/roundness.h"
#include "mesh/topology.h"
#include "prune/border_angles.h"

#include <algorithm>

namespace qm {
namespace {

/// Whether a line turns about as much at its next vertices on both sides, like a coarse circle.
bool isRound(double before, double after, double turn) {
    return std::min(before, after) > roundLine * turn;
}

/// The turn of a line at the end of a halfedge, degrees; 0 where the line ends.
double turnAfter(const QuadMesh& mesh, HalfedgeId halfedge) {
    if (!continuesStraight(mesh, mesh.to_vertex_handle(halfedge))) return 0;
    return turnBetween(mesh, mesh.opposite_halfedge_handle(halfedge), straightOn(mesh, halfedge));
}

/// Whether a track ends at a corner of sharp borders inside a side, so that another has to go straight on.
/// \param arriving  the track's last halfedge
bool endsAtCorner(const PrunedMesh& pruned, const Borders& borders, HalfedgeId arriving, double maxTurn) {
    const QuadMesh& mesh = pruned.mesh;
    if (!continuesStraight(mesh, mesh.to_vertex_handle(arriving))) return false;
    const auto isSharpBorder = [&](HalfedgeId halfedge) {
        return borders.isBorder(halfedge) && isSharp(mesh, pruned.dihedralAngles, halfedge);
    };
    const auto [left, right] = crossingAt(mesh, arriving);
    if (borders.isBorder(straightOn(mesh, arriving)) || !isSharpBorder(arriving) || !isSharpBorder(left) ||
        !isSharpBorder(right))
        return false;
    const double turn = turnBetween(mesh, left, right);
    return turn > maxTurn && !isRound(turnAfter(mesh, left), turnAfter(mesh, right), turn);
}

/// How much the mesh boundary turns at a vertex of it, degrees.
double boundaryTurn(const QuadMesh& mesh, VertexId vertex) {
    const HalfedgeId onward = mesh.halfedge_handle(vertex);
    return turnBetween(mesh, onward, mesh.opposite_halfedge_handle(mesh.prev_halfedge_handle(onward)));
}

/// Whether the mesh boundary has a corner at a vertex of two quads.
bool isCornerOfOutline(const QuadMesh& mesh, VertexId vertex, double maxTurn) {
    if (!mesh.is_boundary(vertex) || mesh.valence(vertex) != 3) return false;
    const double turn = boundaryTurn(mesh, vertex);
    if (turn <= maxTurn) return false;
    const HalfedgeId onward = mesh.halfedge_handle(vertex); // on the boundary
    const VertexId before = mesh.from_vertex_handle(mesh.prev_halfedge_handle(onward)),
                   after = mesh.to_vertex_handle(onward);
    return !isRound(boundaryTurn(mesh, before), boundaryTurn(mesh, after), turn);
}

} // namespace

void cutTurnedSides(const PrunedMesh& pruned, double maxTurn, AddedTracks& tracks) {
    const QuadMesh& mesh = pruned.mesh;
    const auto goOn = [&](HalfedgeId end) {
        std::optional<HalfedgeId> arriving = end;
        while (arriving && endsAtCorner(pruned, tracks.borders(), *arriving, maxTurn))
            arriving = tracks.addFrom(straightOn(mesh, *arriving));
    };
    for (const Track& track : tracks.earlierTracks()) {
        goOn(track.halfedges.back());
        goOn(mesh.opposite_halfedge_handle(track.halfedges.front()));
    }
}

void cutTurnedOutlines(const QuadMesh& mesh, double maxTurn, AddedTracks& tracks) {
    for (const VertexId vertex : mesh.vertices()) {
        if (!isCornerOfOutline(mesh, vertex, maxTurn)) continue;
        const HalfedgeId inner = mesh.cw_rotated_halfedge_handle(mesh.halfedge_handle(vertex));
        if (!tracks.borders().isBorder(inner)) tracks.addFrom(inner);
    }
}

} // namespace qm
