#include "prune/rounded_edges.h"

#include "base/at.h"
#include "mesh/bounding_box.h"
#include "mesh/mesh_lines.h"
#include "mesh/roundness.h"
#include "mesh/topology.h"
#include "prune/border_angles.h"

#include <algorithm>

namespace qm {
namespace {

struct Limits {
    static constexpr double minAngle = 0.7; ///< radians; below 45 degrees, the angle of chamfers
    /// Radians; no round part bends by more at an edge, however coarse its quads.
    static constexpr double surelySharp = 1.2;
    // By how much the surface moves where an edge is rounded off, as shares of the diagonal: three tolerances
    // of a fit, as they are usual, or one.
    static constexpr double maxRounding = 0.003;
    static constexpr double maxRoundingIfSurelySharp = 0.001;
};

class RoundedEdges {
public:
    explicit RoundedEdges(const PrunedMesh& pruned)
        : mesh_(pruned.mesh), angles_(pruned.dihedralAngles), diagonal_(boundingBox(mesh_).diagonal()) {
        const Components parts = components(mesh_);
        std::vector<bool> isPlainTorus(at(parts.count), true);
        const auto divide = [&](VertexId vertex) { isPlainTorus[at(parts.ofVertex[at(vertex)])] = false; };
        for (const VertexId vertex : mesh_.vertices())
            if (!isRegular(mesh_, vertex) || mesh_.is_boundary(vertex)) divide(vertex);
        for (const Seed& seed : pruned.complex.seeds)
            divide(mesh_.from_vertex_handle(seed.direction));
        for (const VertexId vertex : mesh_.vertices())
            isOnPlainTorus_.push_back(isPlainTorus[at(parts.ofVertex[at(vertex)])]);
    }

    void cut(AddedTracks& tracks) const {
        forEachMeshLine(mesh_, [&](const MeshLine& line) {
            if (isOnPlainTorus_[at(mesh_.from_vertex_handle(line.halfedges.front()))]) return;
            std::vector<HalfedgeId> run; // of sharp edges
            for (const HalfedgeId halfedge : line.halfedges) {
                if (isSharp(mesh_, angles_, halfedge)) {
                    run.push_back(halfedge);
                    continue;
                }
                cutAlong(run, tracks);
                run.clear();
            }
            cutAlong(run, tracks);
        });
    }

private:
    void cutAlong(const std::vector<HalfedgeId>& run, AddedTracks& tracks) const {
        const bool isRound = roundness(mesh_, run) > roundLine;
        for (const HalfedgeId halfedge : run)
            if (!tracks.borders().isBorder(halfedge) && isRoundedOff(halfedge, isRound))
                tracks.addThrough(halfedge);
    }

    [[nodiscard]] bool isRoundedOff(HalfedgeId halfedge, bool isRound) const {
        const double angle = angles_[at(mesh_.edge_handle(halfedge))];
        if (angle > Limits::surelySharp)
            return rounding(halfedge) > Limits::maxRoundingIfSurelySharp * diagonal_;
        return angle > Limits::minAngle && !isRound && rounding(halfedge) > Limits::maxRounding * diagonal_;
    }

    /// About how far a smooth surface through the vertices is from the quads beside an edge.
    [[nodiscard]] double rounding(HalfedgeId halfedge) const {
        const auto width = [&](HalfedgeId side) {
            return (mesh_.calc_edge_length(mesh_.next_halfedge_handle(side)) +
                    mesh_.calc_edge_length(mesh_.prev_halfedge_handle(side))) /
                   2;
        };
        constexpr double share = 0.125; // of a parabola that has the angle between its tangents
        return std::min(width(halfedge), width(mesh_.opposite_halfedge_handle(halfedge))) *
               angles_[at(mesh_.edge_handle(halfedge))] * share;
    }

    const QuadMesh& mesh_;
    const std::vector<double>& angles_; ///< dihedral, by edge
    double diagonal_;
    std::vector<bool> isOnPlainTorus_; ///< by vertex, whether no track starts or ends in its component
};

} // namespace

void cutAlongRoundedEdges(const PrunedMesh& pruned, AddedTracks& tracks) {
    RoundedEdges(pruned).cut(tracks);
}

} // namespace qm
