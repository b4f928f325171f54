#include "bspline/reference/limit/even_speeds.h"

#include "base/at.h"
#include "base/infinity.h"
#include "bspline/reference/lattice/hermite.h"
#include "bspline/reference/lattice/lagrange.h"
#include "bspline/reference/lattice/sound_faces.h"
#include "bspline/reference/limit/crease_directions.h"
#include "bspline/reference/limit/parabolic_ends.h"
#include "mesh/parallel_elements.h"
#include "mesh/topology.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace qm {
namespace {

/// Limits of what a derivative is multiplied by. Where edges are very uneven, derivatives along long ones are
/// too short by far, and their directions are no better: they are not made much longer.
constexpr double minFactor = 0.05;
constexpr double maxFactor = 1.25;

/// Of a derivative: it is turned first.
struct Change {
    double share = 0; ///< of itself
    Point turn{0, 0, 0};

    bool operator==(const Change&) const = default;
};

class EvenSpeeds {
public:
    EvenSpeeds(MeshLattice& lattice, const Sharpness& sharpness)
        : lattice_(lattice), before_(lattice), mesh_(lattice.numbers().mesh()), sharpness_(sharpness),
          changes_(mesh_.n_halfedges()), hermite_(hermiteByStep(lattice.squares())) {}

    void run(const PlaneCorners& corners, unsigned jobs) {
        const std::vector<bool> isSound = soundVertices(mesh_, jobs);
        const std::vector<bool> isUnfolded = soundVertices(mesh_, jobs, notFolded);
        const std::vector<Point> directions = creaseDirections(mesh_, sharpness_.rules);
        for (const Turn& turn : parabolicEnds(before_, sharpness_))
            if (isSound[at(mesh_.from_vertex_handle(turn.leaving))])
                changes_[at(turn.leaving)].turn += corners.within(turn.leaving, turn.by);
        parallelForVertices(mesh_, jobs, [&](VertexId vertex) {
            const std::size_t k = at(vertex);
            if (!isUnfolded[k]) return;
            if (!mesh_.is_boundary(vertex) && mesh_.valence(vertex) != 4) {
                shortenAtExtraordinary(leavingFrom(mesh_, mesh_.halfedge_handle(vertex)));
                return;
            }
            if (isSound[k] && isRegularCrease(mesh_, vertex, sharpness_.rules[k]))
                turn(sharpness_.rules[k], corners.within(sharpness_.rules[k].along[0], directions[k]));
            for (const HalfedgeId leaving : mesh_.voh_range(vertex))
                changes_[at(leaving)].share = shareOf(leaving);
        });
        parallelForEdges(mesh_, jobs, [&](EdgeId edge) { moveEdge(mesh_.halfedge_handle(edge, 0)); });
        parallelForFaces(mesh_, jobs, [&](FaceId face) { moveFace(mesh_.halfedge_handle(face)); });
    }

private:
    /// Turns the derivatives along a crease into a direction.
    void turn(const VertexRule& rule, const Point& direction) {
        if (direction.sqrnorm() == 0) return;
        const Point unit = direction.normalized();
        for (std::size_t k = 0; k < 2; ++k) {
            const Point now = before_.derivative(rule.along[k]);
            changes_[at(rule.along[k])].turn = now.norm() * (k == 0 ? unit : -unit) - now;
        }
    }

    /// What a change adds to the derivative along a row of points at one of its ends. A change at the last
    /// one is that of a derivative against the row.
    template <class Row>
    [[nodiscard]] Point difference(std::size_t end, const Change& change, const Row& row) const {
        const Point turn = end == 0 ? change.turn : -change.turn;
        return change.share * (derivativeAtEnd(before_.squares(), end, row) + turn) + turn;
    }

    /// By what share of itself the derivative along an edge, turned already, is to change at its beginning.
    [[nodiscard]] double shareOf(HalfedgeId leaving) const {
        const Point chord = mesh_.calc_edge_vector(leaving);
        const Point speed = before_.derivative(leaving) + changes_[at(leaving)].turn;
        const double product = chord.norm() * speed.norm();
        if (!(product > 0)) return 0;
        // A cubic is nearest to an arc if its derivative exceeds the chord by this factor.
        const double ofArc = 2 / (1 + std::max(0.0, (chord | speed) / product));
        const double wanted = std::min(ofArc * chord.norm(), maxSpeedUp * lengthBehind(leaving));
        return std::clamp(wanted / speed.norm(), minFactor, maxFactor) - 1;
    }

    /// The same for all edges of an extraordinary vertex. Derivatives of a subdivision surface are there what
    /// the polynomials make of them; they only become shorter, and only beside much shorter edges.
    void shortenAtExtraordinary(const std::vector<HalfedgeId>& ring) {
        const std::size_t count = ring.size();
        for (std::size_t k = 0; k < count; ++k) {
            const double speed = before_.derivative(ring[k]).norm();
            if (!(speed > 0)) continue;
            // Of an odd number of edges, two are opposite.
            const double behind = std::min(mesh_.calc_edge_length(ring[(k + count / 2) % count]),
                                           mesh_.calc_edge_length(ring[(k + (count + 1) / 2) % count]));
            changes_[at(ring[k])].share = std::clamp(maxSpeedUp * behind / speed, minFactor, 1.0) - 1;
        }
    }

    /// The length of the edge that the line comes over to a regular vertex. Without limit on the boundary.
    [[nodiscard]] double lengthBehind(HalfedgeId leaving) const {
        if (mesh_.is_boundary(mesh_.from_vertex_handle(leaving))) return infinity;
        const HalfedgeId next = mesh_.ccw_rotated_halfedge_handle(leaving);
        return mesh_.calc_edge_length(mesh_.ccw_rotated_halfedge_handle(next));
    }

    void moveEdge(HalfedgeId side) {
        const std::array ends{changes_[at(side)], changes_[at(mesh_.opposite_halfedge_handle(side))]};
        if (ends[0] == Change{} && ends[1] == Change{}) return;
        const auto row = [&](int k) { return before_.point(side, k, 0); };
        const std::array differences{difference(0, ends[0], row), difference(1, ends[1], row)};
        lattice_.moveEdge(side, [&](int k) {
            const auto& slope = hermite_[at(k)].slope;
            return row(k) + slope[0][0] * differences[0] + slope[1][0] * differences[1];
        });
    }

    /// A change at a corner of a face, and how its turn varies across the face, from the first side on.
    struct Corner {
        Change change;
        Point slope;
    };
    /// The changes along both sides of a face that run in one direction, by end and side: those at the
    /// beginnings of the first side, and of the one opposite to it.
    using Changes = std::array<std::array<Corner, 2>, 2>;

    [[nodiscard]] Changes changesAlong(HalfedgeId side) const {
        const auto along = [&](HalfedgeId leaving) -> Corner {
            return {changes_[at(leaving)], slopeToLeft(leaving)};
        };
        const auto against = [&](HalfedgeId leaving) -> Corner {
            return {changes_[at(leaving)], -slopeToLeft(leaving)};
        };
        const HalfedgeId far = acrossQuad(mesh_, side);
        return {
            {{along(side), along(far)},
             {against(mesh_.opposite_halfedge_handle(side)), against(mesh_.opposite_halfedge_handle(far))}}};
    }

    /// How the turn of a mesh line varies from line to line, at the beginning of a halfedge, for each line to
    /// the left: by the lines on both sides. Otherwise turns would vary in steps, and the surface ripple.
    [[nodiscard]] Point slopeToLeft(HalfedgeId leaving) const {
        if (sharpness_.edges[at(mesh_.edge_handle(leaving))]) return {0, 0, 0};
        const HalfedgeId left = acrossQuad(mesh_, leaving);
        const HalfedgeId right =
            mesh_.opposite_halfedge_handle(acrossQuad(mesh_, mesh_.opposite_halfedge_handle(leaving)));
        const Point difference = changes_[at(left)].turn - changes_[at(right)].turn;
        if (difference == Point(0, 0, 0)) return difference;
        // Where a line goes on, it turns against itself on the other side, and so must its neighbours.
        const auto kindAt = [&](HalfedgeId line) {
            return sharpness_.rules[at(mesh_.from_vertex_handle(line))].kind;
        };
        const auto goesOn = [&](HalfedgeId line) {
            return kindAt(line) == VertexRule::Kind::smooth &&
                   continuesStraight(mesh_, mesh_.from_vertex_handle(line));
        };
        const bool ends =
            kindAt(leaving) == VertexRule::Kind::crease || kindAt(leaving) == VertexRule::Kind::corner;
        return ends || (goesOn(left) && goesOn(right)) ? difference / 2 : Point(0, 0, 0);
    }

    void moveFace(HalfedgeId first) {
        const HalfedgeId last = mesh_.prev_halfedge_handle(first);
        const Changes alongU = changesAlong(first);
        const Changes alongV = turned(changesAlong(last));
        lattice_.moveInside(first, [&](int i, int j) {
            const auto row = [&](int k) { return before_.point(first, k, j); };
            const auto column = [&](int k) { return before_.point(first, i, k); };
            const Hermite& u = hermite_[at(i)];
            const Hermite& v = hermite_[at(j)];
            Point to = before_.point(first, i, j);
            for (std::size_t end = 0; end < 2; ++end) {
                to += u.slope[end][0] * difference(end, between(alongU[end], v), row);
                to += v.slope[end][0] * difference(end, between(alongV[end], u), column);
            }
            return to;
        });
    }

    /// The last side of a face runs against v, at u = 0: the same changes by end and side of v.
    [[nodiscard]] static Changes turned(const Changes& changes) { return {changes[1], changes[0]}; }

    [[nodiscard]] static Change between(const std::array<Corner, 2>& corners, const Hermite& place) {
        Change sum;
        for (std::size_t k = 0; k < 2; ++k) {
            const double value = place.value[k][0];
            sum.share += value * corners[k].change.share;
            sum.turn += value * corners[k].change.turn + place.slope[k][0] * corners[k].slope;
        }
        return sum;
    }

    MeshLattice& lattice_;
    const MeshLattice before_;
    const QuadMesh& mesh_;
    Sharpness sharpness_;
    std::vector<Change> changes_; ///< by halfedge: of the derivative at its beginning
    std::vector<Hermite> hermite_;
};

} // namespace

void evenSpeeds(MeshLattice& lattice, const Sharpness& sharpness, const PlaneCorners& corners,
                unsigned jobs) {
    EvenSpeeds(lattice, sharpness).run(corners, jobs);
}

} // namespace qm
