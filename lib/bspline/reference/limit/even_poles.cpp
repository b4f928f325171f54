#include "bspline/reference/limit/even_poles.h"

#include "base/at.h"
#include "base/infinity.h"
#include "bspline/reference/lattice/hermite.h"
#include "bspline/reference/lattice/lagrange.h"
#include "bspline/reference/limit/even_speeds.h"
#include "bspline/splines/evaluate.h"
#include "mesh/parallel_elements.h"
#include "mesh/topology.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace qm {
namespace {

/// Smooth interior vertices of more edges than this are poles.
constexpr unsigned maxEdgesOfOrdinary = 7;

/// The least speed along an edge, in terms of its length.
constexpr double minSpeed = 0.5;

/// Smallest cosine of the angle between an edge and the tangent plane: of 78 degrees.
constexpr double minCosine = 0.2;

/// Length of the mean of the normals around a vertex, below which it has no tangent plane.
constexpr double minAgreement = 0.3;

class EvenPoles {
public:
    EvenPoles(MeshLattice& lattice, const std::vector<VertexRule>& rules)
        : lattice_(lattice), before_(lattice), mesh_(lattice.numbers().mesh()), steps_(lattice.squares()),
          rules_(rules), turns_(mesh_.n_halfedges(), Point(0, 0, 0)),
          twists_(mesh_.n_halfedges(), Point(0, 0, 0)), hermite_(hermiteByStep(lattice.squares())) {}

    void run(unsigned jobs) {
        parallelForVertices(mesh_, jobs, [&](VertexId vertex) { turn(vertex); });
        parallelForEdges(mesh_, jobs, [&](EdgeId edge) { moveEdge(mesh_.halfedge_handle(edge, 0)); });
        parallelForFaces(mesh_, jobs, [&](FaceId face) { moveFace(face); });
    }

private:
    /// A derivative of the polynomial over a halfedge's face, at the halfedge's beginning: the `along`-th
    /// along the halfedge, and the `across`-th across it.
    [[nodiscard]] Point derivative(HalfedgeId leaving, std::size_t along, std::size_t across) const {
        const LagrangeWeights& weights = lagrangeAtEnd(steps_, 0);
        Point sum(0, 0, 0);
        for (int j = 0; j <= (across == 0 ? 0 : steps_); ++j)
            for (int i = 0; i <= steps_; ++i)
                sum += weights[at(i)][along] * (across == 0 ? 1 : weights[at(j)][across]) *
                       before_.point(leaving, i, j);
        return sum;
    }

    /// The mean of the unit normals of the quads around a vertex.
    [[nodiscard]] Point meanNormal(const std::vector<HalfedgeId>& ring) const {
        Point sum(0, 0, 0);
        for (std::size_t k = 0; k < ring.size(); ++k)
            sum += unit(before_.derivative(ring[k]) % before_.derivative(ring[(k + 1) % ring.size()]));
        return sum / static_cast<double>(ring.size());
    }

    /// The derivative, along an edge seen in the tangent plane, with which the curve over the edge advances
    /// most evenly; zero if the edge is too steep.
    [[nodiscard]] Point tangent(HalfedgeId leaving, const Point& normal, double maxSpeed) const {
        const Point chord = mesh_.calc_edge_vector(leaving);
        const Point flat = chord - normal * (normal | chord);
        const double length = flat.norm();
        if (!(length > minCosine * chord.norm())) return {0, 0, 0};
        const Point direction = flat / length;
        const Point begin = before_.point(leaving, 0, 0);
        double missing = 0;
        double squares = 0;
        for (int k = 1; k < steps_; ++k) {
            const Point way = before_.point(leaving, k, 0) - begin;
            const double slope = hermite_[at(k)].slope[0][0];
            missing += slope * (length * k / steps_ - (direction | way));
            squares += slope * slope;
        }
        const double speed = (direction | before_.derivative(leaving)) + missing / squares;
        return direction * std::clamp(speed, minSpeed * length, std::max(maxSpeed, minSpeed * length));
    }

    /// In the order of a ring; nothing if its vertex is no pole.
    [[nodiscard]] std::vector<Point> tangentsAt(const std::vector<HalfedgeId>& ring,
                                                const Point& normal) const {
        double shortest = infinity;
        for (const HalfedgeId leaving : ring)
            shortest = std::min(shortest, mesh_.calc_edge_length(leaving));
        std::vector<Point> tangents;
        tangents.reserve(ring.size());
        for (const HalfedgeId leaving : ring)
            tangents.push_back(tangent(leaving, normal, maxSpeedUp * shortest));
        for (std::size_t k = 0; k < ring.size(); ++k)
            if (!((normal | (tangents[k] % tangents[(k + 1) % ring.size()])) > 0)) return {};
        return tangents;
    }

    void turn(VertexId vertex) {
        const std::size_t count = mesh_.valence(vertex);
        if (rules_[at(vertex)].kind != VertexRule::Kind::smooth || count <= maxEdgesOfOrdinary) return;
        const std::vector<HalfedgeId> ring = leavingFrom(mesh_, mesh_.halfedge_handle(vertex));
        const Point mean = meanNormal(ring);
        if (!(mean.norm() > minAgreement)) return;
        const Point normal = unit(mean);
        const std::vector<Point> tangents = tangentsAt(ring, normal);
        if (tangents.empty()) return;
        std::vector<Point> bends; // second derivatives along the edges
        for (std::size_t k = 0; k < count; ++k) {
            const Point gain = tangents[k] - before_.derivative(ring[k]);
            turns_[at(ring[k])] = gain;
            const double ofSlope = hermite_.front().slope[0][2];
            bends.push_back(derivative(ring[k], 2, 0) + ofSlope * gain);
        }
        // The mixed derivatives on both sides of an edge are to sum to lambda times what its bend exceeds
        // twice its tangent by, as those of the fitted surfaces do where lambda reaches over an edge.
        const double lambda = 2 * std::cos(2 * std::numbers::pi / static_cast<double>(count));
        for (std::size_t k = 0; k < count; ++k) {
            const std::size_t next = (k + 1) % count;
            const Point bend = bends[k] + bends[next];
            const Point up = normal * (normal | bend);
            const Point within = bend - up - 2 * (tangents[k] + tangents[next]);
            twists_[at(ring[k])] =
                lambda / 4 * up + lambda / (2 + lambda) * within - derivative(ring[k], 1, 1);
        }
    }

    void moveEdge(HalfedgeId side) {
        const Point& first = turns_[at(side)];
        const Point& last = turns_[at(mesh_.opposite_halfedge_handle(side))];
        lattice_.moveEdge(side, [&](int k) {
            const auto& slope = hermite_[at(k)].slope;
            return lattice_.point(side, k, 0) + slope[0][0] * first - slope[1][0] * last;
        });
    }

    void moveFace(FaceId face) {
        for (const HalfedgeId side : mesh_.fh_range(face)) {
            const Point& alongU = turns_[at(side)];
            const Point& alongV =
                turns_[at(mesh_.opposite_halfedge_handle(mesh_.prev_halfedge_handle(side)))];
            lattice_.moveInside(side, [&](int i, int j) {
                const Hermite& u = hermite_[at(i)];
                const Hermite& v = hermite_[at(j)];
                return lattice_.point(side, i, j) + u.slope[0][0] * v.value[0][0] * alongU +
                       u.value[0][0] * v.slope[0][0] * alongV +
                       u.slope[0][0] * v.slope[0][0] * twists_[at(side)];
            });
        }
    }

    MeshLattice& lattice_;
    const MeshLattice before_;
    const QuadMesh& mesh_;
    int steps_;
    const std::vector<VertexRule>& rules_;
    std::vector<Point> turns_;  ///< by halfedge: what its derivative gains at its beginning
    std::vector<Point> twists_; ///< by halfedge: what the mixed derivative of its face gains there
    std::vector<Hermite> hermite_;
};

} // namespace

void evenPoles(MeshLattice& lattice, const std::vector<VertexRule>& rules, unsigned jobs) {
    const QuadMesh& mesh = lattice.numbers().mesh();
    const auto hasManyEdges = [&](VertexId vertex) { return mesh.valence(vertex) > maxEdgesOfOrdinary; };
    if (std::ranges::none_of(mesh.vertices(), hasManyEdges)) return;
    EvenPoles(lattice, rules).run(jobs);
}

} // namespace qm
