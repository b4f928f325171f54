#include "prune/turned_sides.h"

#include "base/at.h"
#include "layout/borders.h"
#include "layout/tracks.h"
#include "mesh/roundness.h"
#include "mesh/topology.h"
#include "prune/border_angles.h"

#include <algorithm>
#include <iterator>

namespace qm {
namespace {

class Corners {
public:
    Corners(const QuadMesh& mesh, const std::vector<Track>& tracks, const std::vector<double>& dihedralAngles,
            const std::vector<EdgeId>& forbidden)
        : mesh_(mesh), dihedralAngles_(dihedralAngles), borders_(mesh, tracks), isForbidden_(mesh.n_edges()) {
        for (const EdgeId edge : forbidden)
            isForbidden_[at(edge)] = true;
    }

    /// What goes straight on from the end of a track to the next border; empty if nothing needs to.
    /// \param arriving  the track's last halfedge
    std::vector<HalfedgeId> pathFrom(HalfedgeId arriving, double maxTurn) {
        if (!continuesStraight(mesh_, mesh_.to_vertex_handle(arriving))) return {};
        std::vector<HalfedgeId> path{straightOn(mesh_, arriving)};
        const auto [left, right] = crossingAt(mesh_, arriving);
        if (borders_.isBorder(path.front()) || !isSharpBorder(arriving) || !isSharpBorder(left) ||
            !isSharpBorder(right))
            return {};
        const double turn = turnBetween(mesh_, left, right);
        if (turn <= maxTurn || isRound(turnAfter(left), turnAfter(right), turn)) return {};
        return toNextBorder(std::move(path));
    }

    /// What goes from a vertex of the mesh boundary to the next border; empty if the boundary does not turn
    /// there, or if the two quads inside have a border between them.
    std::vector<HalfedgeId> pathFrom(VertexId corner, double maxTurn) {
        if (!mesh_.is_boundary(corner) || mesh_.valence(corner) != 3) return {};
        const HalfedgeId onward = mesh_.halfedge_handle(corner); // on the boundary
        const HalfedgeId inner = mesh_.cw_rotated_halfedge_handle(onward);
        const double turn = boundaryTurn(corner);
        if (turn <= maxTurn || borders_.isBorder(inner)) return {};
        const double before = boundaryTurn(mesh_.from_vertex_handle(mesh_.prev_halfedge_handle(onward)));
        if (isRound(before, boundaryTurn(mesh_.to_vertex_handle(onward)), turn)) return {};
        return toNextBorder({inner});
    }

private:
    std::vector<HalfedgeId> toNextBorder(std::vector<HalfedgeId> path) {
        while (!borders_.hasBorder(mesh_.to_vertex_handle(path.back())))
            path.push_back(straightOn(mesh_, path.back()));
        if (std::ranges::any_of(path, [&](HalfedgeId step) { return isForbidden(step); })) return {};
        borders_.add(path);
        return path;
    }

    /// How much the mesh boundary turns at a vertex of it, degrees.
    [[nodiscard]] double boundaryTurn(VertexId vertex) const {
        const HalfedgeId onward = mesh_.halfedge_handle(vertex);
        return turnBetween(mesh_, onward, mesh_.opposite_halfedge_handle(mesh_.prev_halfedge_handle(onward)));
    }

    [[nodiscard]] bool isSharpBorder(HalfedgeId halfedge) const {
        return borders_.isBorder(halfedge) && isSharp(mesh_, dihedralAngles_, halfedge);
    }

    [[nodiscard]] bool isForbidden(HalfedgeId halfedge) const {
        return isForbidden_[at(mesh_.edge_handle(halfedge))];
    }

    /// Whether a line turns about as much at its next vertices on both sides, like a coarse circle.
    static bool isRound(double before, double after, double turn) {
        return std::min(before, after) > roundLine * turn;
    }

    /// The turn of a line at the end of a halfedge, degrees; 0 where the line ends.
    [[nodiscard]] double turnAfter(HalfedgeId halfedge) const {
        if (!continuesStraight(mesh_, mesh_.to_vertex_handle(halfedge))) return 0;
        return turnBetween(mesh_, mesh_.opposite_halfedge_handle(halfedge), straightOn(mesh_, halfedge));
    }

    const QuadMesh& mesh_;
    const std::vector<double>& dihedralAngles_;
    Borders borders_;
    std::vector<bool> isForbidden_; ///< by edge
};

Layout withAdded(const PrunedMesh& pruned, const Layout& layout, std::vector<Track> tracks,
                 std::vector<Track> added) {
    if (added.empty()) return layout;
    std::ranges::move(added, std::back_inserter(tracks));
    return buildLayout(pruned.mesh, tracks, pruned.dihedralAngles, pruned.edgeCosts);
}

} // namespace

Layout cutTurnedSides(const PrunedMesh& pruned, const Layout& layout, double maxTurn,
                      const std::vector<EdgeId>& forbidden) {
    const QuadMesh& mesh = pruned.mesh;
    std::vector<Track> tracks = properTracks(layout), added;
    Corners corners(mesh, tracks, pruned.dihedralAngles, forbidden);
    const auto goOn = [&](HalfedgeId arriving) {
        for (auto path = corners.pathFrom(arriving, maxTurn); !path.empty();
             path = corners.pathFrom(path.back(), maxTurn))
            added.push_back(trackOf(mesh, path, pruned.edgeCosts));
    };
    for (const Track& track : tracks) {
        goOn(track.halfedges.back());
        goOn(mesh.opposite_halfedge_handle(track.halfedges.front()));
    }
    return withAdded(pruned, layout, std::move(tracks), std::move(added));
}

Layout cutTurnedOutlines(const PrunedMesh& pruned, const Layout& layout, double maxTurn,
                         const std::vector<EdgeId>& forbidden) {
    std::vector<Track> tracks = properTracks(layout), added;
    Corners corners(pruned.mesh, tracks, pruned.dihedralAngles, forbidden);
    for (const VertexId vertex : pruned.mesh.vertices())
        if (const auto path = corners.pathFrom(vertex, maxTurn); !path.empty())
            added.push_back(trackOf(pruned.mesh, path, pruned.edgeCosts));
    return withAdded(pruned, layout, std::move(tracks), std::move(added));
}

} // namespace qm
