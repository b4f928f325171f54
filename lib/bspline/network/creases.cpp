#include "bspline/network/creases.h"

#include "base/at.h"
#include "bspline/network/vertex_fan.h"
#include "bspline/network/vertex_rules.h"
#include "mesh/angle_between.h"
#include "mesh/roundness.h"
#include "mesh/topology.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

namespace qm {
namespace {

/// Above this dihedral angle, in radians, a crease may end anywhere.
constexpr double certain = 1.0;

/// Longer curves may end anywhere, too.
constexpr std::size_t maxEdges = 4;

/// Share of rho: an edge that is sharper may be a crease because of those that it meets.
constexpr double shareBetween = 0.5;

/// Curves of more roundness that end in nothing, which is suspicious itself, are no creases.
constexpr double maxRoundnessIfLoose = 0.25;

class Creases {
public:
    Creases(const QuadMesh& mesh, const std::vector<double>& dihedralAngles, BorderMarks marks)
        : mesh_(mesh), angles_(dihedralAngles), marks_(std::move(marks)) {}

    void smoothRoundCurves() {
        std::vector<HalfedgeId> ofRound;
        std::vector<bool> isVisited(mesh_.n_edges());
        for (const EdgeId edge : mesh_.edges()) {
            const HalfedgeId first = mesh_.halfedge_handle(edge, 0);
            if (isVisited[at(edge)] || !isCrease(first) || mesh_.is_boundary(edge)) continue;
            // To one end, and from there to the other.
            const auto curve = curveFrom(mesh_.opposite_halfedge_handle(curveFrom(first).back()));
            for (const HalfedgeId halfedge : curve)
                isVisited[index(halfedge)] = true;
            if (roundness(mesh_, curve) > roundLine)
                ofRound.insert(ofRound.end(), curve.begin(), curve.end());
        }
        mark(ofRound, false);
    }

    void closeGaps(double minAngle) {
        spread([&](VertexId vertex, std::vector<VertexId>& waiting) {
            for (const HalfedgeId next : wantedAt(vertex)) {
                if (isCrease(next)) continue; // since another one was closed
                const std::vector<HalfedgeId> gap = gapFrom(next, minAngle);
                mark(gap, true);
                if (!gap.empty()) waiting.push_back(mesh_.to_vertex_handle(gap.back()));
            }
        });
    }

    void takeBackLooseEnds() {
        spread([&](VertexId vertex, std::vector<VertexId>& waiting) {
            // What remains at the curve's other end may be a loose end now.
            if (const auto end = takeBackFrom(vertex)) waiting.push_back(*end);
        });
    }

    void completeCorners(double rho) {
        spread([&](VertexId vertex, std::vector<VertexId>& waiting) {
            for (const HalfedgeId border : missingAt(vertex, rho)) {
                marks_.isCrease[index(border)] = true;
                // Either end may need more now.
                waiting.push_back(vertex);
                waiting.push_back(mesh_.to_vertex_handle(border));
            }
        });
    }

    BorderMarks marks() && { return std::move(marks_); }

private:
    /// Visits all vertices, and again those that a visit adds to what is waiting.
    template <class Visit> void spread(const Visit& visit) {
        std::vector<VertexId> waiting(mesh_.vertices_begin(), mesh_.vertices_end());
        while (!waiting.empty()) {
            const VertexId vertex = waiting.back();
            waiting.pop_back();
            visit(vertex, waiting);
        }
    }

    [[nodiscard]] std::size_t index(HalfedgeId halfedge) const { return at(mesh_.edge_handle(halfedge)); }
    [[nodiscard]] bool isCrease(HalfedgeId halfedge) const { return marks_.isCrease[index(halfedge)]; }

    void mark(const std::vector<HalfedgeId>& curve, bool isCrease) {
        for (const HalfedgeId halfedge : curve)
            marks_.isCrease[index(halfedge)] = isCrease;
    }

    /// The borders that leave a vertex: those that are creases, or the others.
    [[nodiscard]] std::vector<HalfedgeId> bordersAt(VertexId vertex, bool areCreases) const {
        std::vector<HalfedgeId> borders;
        for (const HalfedgeId halfedge : mesh_.voh_range(vertex))
            if (marks_.isBorder[index(halfedge)] && isCrease(halfedge) == areCreases)
                borders.push_back(halfedge);
        return borders;
    }

    /// Borders at a vertex that would complete the creases there: what goes straight on from a loose end, and
    /// all of a corner's, whose creases do not lie in one tangent plane.
    [[nodiscard]] std::vector<HalfedgeId> wantedAt(VertexId vertex) const {
        const std::vector<HalfedgeId> creases = bordersAt(vertex, true);
        if (creases.size() > 2 || isCornerOfTwo(vertex)) return bordersAt(vertex, false);
        if (creases.size() == 1 && continuesStraight(mesh_, vertex))
            return {straightOn(mesh_, mesh_.opposite_halfedge_handle(creases.front()))};
        return {};
    }

    /// Straight on over borders above an angle as far as creases; nothing if there are none, or if the
    /// surface is round there.
    [[nodiscard]] std::vector<HalfedgeId> gapFrom(HalfedgeId first, double minAngle) const {
        std::vector<HalfedgeId> gap;
        for (HalfedgeId next = first;; next = straightOn(mesh_, next)) {
            if (!marks_.isBorder[index(next)] || angles_[index(next)] <= minAngle) return {};
            gap.push_back(next);
            const VertexId end = mesh_.to_vertex_handle(next);
            if (!bordersAt(end, true).empty())
                return roundness(mesh_, gap) > roundLine ? std::vector<HalfedgeId>{} : gap;
            if (!continuesStraight(mesh_, end)) return {};
        }
    }

    /// The only crease that leaves a vertex beside one that arrives, if there is one and no more.
    [[nodiscard]] HalfedgeId onlyCrease(VertexId vertex, HalfedgeId arriving) const {
        std::vector<HalfedgeId> creases = bordersAt(vertex, true);
        if (arriving.is_valid()) std::erase(creases, mesh_.opposite_halfedge_handle(arriving));
        return creases.size() == 1 ? creases.front() : HalfedgeId();
    }

    /// A curve of creases inside the mesh from one of them on: as far as none follows or several do, and once
    /// around if it is closed.
    [[nodiscard]] std::vector<HalfedgeId> curveFrom(HalfedgeId first) const {
        std::vector<HalfedgeId> curve;
        for (HalfedgeId next = first; next.is_valid() && !mesh_.is_boundary(mesh_.edge_handle(next));
             next = onlyCrease(mesh_.to_vertex_handle(next), next)) {
            if (!curve.empty() && next == first) break;
            curve.push_back(next);
        }
        return curve;
    }

    /// \return the other end of the curve that was taken back
    std::optional<VertexId> takeBackFrom(VertexId vertex) {
        const HalfedgeId first = onlyCrease(vertex, HalfedgeId());
        if (!first.is_valid()) return std::nullopt;
        const std::vector<HalfedgeId> curve = curveFrom(first);
        if (curve.empty()) return std::nullopt;
        const VertexId end = mesh_.to_vertex_handle(curve.back());
        const auto isCertain = [&](HalfedgeId halfedge) { return angles_[index(halfedge)] > certain; };
        if (std::ranges::any_of(curve, isCertain)) return std::nullopt;
        if (curve.size() > maxEdges && roundness(mesh_, curve) <= maxRoundnessIfLoose) return std::nullopt;
        mark(curve, false);
        if (!isCornerOfTwo(end)) return end;
        mark(curve, true);
        return std::nullopt;
    }

    /// Two creases meet inside the surface, no side of a patch follows both, and no curve can.
    [[nodiscard]] bool isCornerOfTwo(VertexId vertex) const {
        const std::vector<HalfedgeId> creases = bordersAt(vertex, true);
        if (creases.size() != 2 || mesh_.is_boundary(vertex)) return false;
        const VertexFan fan = vertexFan(mesh_, marks_, vertex);
        bool leavesRoom = true;
        for (std::size_t k = 0; k < fan.borders.size(); ++k) {
            if (fan.faces[k] != 2) continue;
            if (fan.isCrease[k] && fan.isCrease[(k + 1) % fan.borders.size()]) return false;
            leavesRoom = false;
        }
        // A curve takes half a turn on either side, and so does a patch whose side passes straight through.
        return !leavesRoom || !isCurve(mesh_, {creases[0], creases[1]});
    }

    /// At the vertex that a border inside the mesh leaves: its dihedral angle, or the angle between the
    /// corners on both sides of it, which is larger where quads are not plane.
    [[nodiscard]] double angleAt(HalfedgeId leaving) const {
        const Point edge = mesh_.calc_edge_vector(leaving);
        const Point left = edge % mesh_.calc_edge_vector(mesh_.ccw_rotated_halfedge_handle(leaving));
        const Point right = mesh_.calc_edge_vector(mesh_.cw_rotated_halfedge_handle(leaving)) % edge;
        return std::max(angles_[index(leaving)], angleBetween(left, right));
    }

    /// Borders at a corner across which surfaces cannot be smooth there.
    [[nodiscard]] std::vector<HalfedgeId> missingAt(VertexId vertex, double rho) const {
        std::vector<HalfedgeId> others = bordersAt(vertex, false);
        const auto angle = [&](HalfedgeId halfedge) { return angleAt(halfedge); };
        if (bordersAt(vertex, true).size() > 2) {
            std::erase_if(others, [&](HalfedgeId halfedge) { return angle(halfedge) <= rho; });
            return others;
        }
        if (others.empty() || !isCornerOfTwo(vertex)) return {};
        const HalfedgeId sharpest = *std::ranges::max_element(others, {}, angle);
        if (angle(sharpest) <= shareBetween * rho) return {};
        return {sharpest};
    }

    const QuadMesh& mesh_;
    const std::vector<double>& angles_;
    BorderMarks marks_;
};

} // namespace

BorderMarks markBorders(const QuadMesh& mesh, const std::vector<BorderEdge>& borders,
                        const std::vector<double>& dihedralAngles, double rho) {
    BorderMarks marks{std::vector<bool>(mesh.n_edges()), std::vector<bool>(mesh.n_edges())};
    for (const BorderEdge& border : borders) {
        const std::size_t edge = at(mesh.edge_handle(border.halfedge));
        marks.isBorder[edge] = true;
        marks.isCrease[edge] = border.places.size() != 2 || dihedralAngles[edge] > rho;
    }
    Creases creases(mesh, dihedralAngles, std::move(marks));
    creases.smoothRoundCurves();
    creases.closeGaps(shareBetween * rho);
    creases.takeBackLooseEnds();
    creases.completeCorners(rho);
    return std::move(creases).marks();
}

} // namespace qm
