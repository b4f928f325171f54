#include "bspline/reference/bending/min_bending.h"

#include "base/at.h"
#include "base/or_null.h"
#include "bspline/reference/bending/bending_equations.h"
#include "bspline/reference/bending/quad_bending.h"
#include "bspline/reference/lattice/sound_faces.h"
#include "mesh/parallel_elements.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

namespace qm {
namespace {

/// Slopes of up to 20 degrees are believed: where minimal bending asks for more, the surface is far from
/// smooth.
constexpr double maxSlope = 0.36;
/// Length of the mean of the one-sided normals at a vertex, below which it has no tangent plane.
constexpr double minAgreement = 0.5;

class MinBending {
public:
    MinBending(MeshLattice& lattice, const std::vector<VertexRule>& rules, const PlaneCorners& corners,
               unsigned jobs)
        : lattice_(lattice), before_(lattice), mesh_(lattice.numbers().mesh()), jobs_(jobs),
          frames_(mesh_.n_vertices()) {
        const std::vector<bool> isSound = soundVertices(mesh_, jobs_);
        const std::vector<Eigen::Vector3d> normals = sumsOfNormals();
        parallelForVertices(mesh_, jobs_, [&](VertexId vertex) {
            const std::size_t k = at(vertex);
            const bool isFree =
                rules[k].kind == VertexRule::Kind::smooth && isSound[k] && !corners.isBound(vertex);
            if (isFree && normals[k].norm() > minAgreement * mesh_.valence(vertex))
                frames_[k] = frameAround(vertex, normals[k].normalized());
        });
    }

    void run() {
        std::vector<BendingTerm> terms(mesh_.n_faces());
        parallelForFaces(mesh_, jobs_, [&](FaceId face) {
            if (hasFreeCorner(face))
                terms[at(face)] = BendingTerm(vertices(face), quadBending(surface(face), frames(face)));
        });
        std::vector<Eigen::Vector3d> tilts = minBendingTilts(terms, mesh_.n_vertices(), jobs_);
        terms = {};
        for (Eigen::Vector3d& tilt : tilts)
            if (const double slope = tilt.head<2>().norm(); slope > maxSlope) tilt *= maxSlope / slope;
        move(tilts);
    }

private:
    [[nodiscard]] std::array<VertexId, 4> vertices(FaceId face) const {
        return before_.numbers().corners(face);
    }

    [[nodiscard]] bool hasFreeCorner(FaceId face) const {
        return std::ranges::any_of(vertices(face),
                                   [&](VertexId vertex) { return frames_[at(vertex)].has_value(); });
    }

    [[nodiscard]] CornerFrames frames(FaceId face) const {
        CornerFrames result{};
        std::ranges::transform(vertices(face), result.begin(),
                               [&](VertexId vertex) { return orNull(frames_[at(vertex)]); });
        return result;
    }

    [[nodiscard]] QuadSurface surface(FaceId face) const { return {steps(), before_.points(face)}; }

    /// Of the quads around every vertex.
    [[nodiscard]] std::vector<Eigen::Vector3d> sumsOfNormals() const {
        std::vector<std::array<Eigen::Vector3d, 4>> normals(mesh_.n_faces());
        parallelForFaces(mesh_, jobs_, [&](FaceId face) {
            const QuadSurface ofFace = surface(face);
            for (std::size_t corner = 0; corner < 4; ++corner)
                normals[at(face)][corner] = ofFace.normal(corner);
        });
        std::vector<Eigen::Vector3d> sums(mesh_.n_vertices(), Eigen::Vector3d::Zero());
        for (const FaceId face : mesh_.faces()) {
            std::size_t corner = 0;
            for (const VertexId vertex : vertices(face))
                sums[at(vertex)] += normals[at(face)][corner++];
        }
        return sums;
    }

    [[nodiscard]] TangentFrame frameAround(VertexId vertex, const Eigen::Vector3d& normal) const {
        const Eigen::Vector3d along = normal.unitOrthogonal();
        const auto valence = static_cast<int>(mesh_.valence(vertex));
        TangentFrame frame{normal, {along, normal.cross(along)}, {}, twistOfSlopes(valence)};
        frame.dual.fill(Eigen::Vector3d::Zero());
        if (valence != 4) return frame;
        const HalfedgeId first = mesh_.halfedge_handle(vertex);
        const Eigen::Vector3d u = vector(before_.derivative(first));
        const Eigen::Vector3d v = vector(before_.derivative(mesh_.ccw_rotated_halfedge_handle(first)));
        const double area = normal.dot(u.cross(v));
        constexpr double minSine = 0.1;
        if (area > minSine * u.norm() * v.norm())
            frame.dual = {v.cross(normal) / area, normal.cross(u) / area};
        return frame;
    }

    void move(const std::vector<Eigen::Vector3d>& tilts) {
        parallelForFaces(mesh_, jobs_, [&](FaceId face) {
            if (!hasFreeCorner(face)) return;
            CornerTilts ofCorners;
            Eigen::Index row = 0;
            for (const VertexId vertex : vertices(face)) {
                ofCorners.segment<3>(row) = tilts[at(vertex)];
                row += 3;
            }
            const auto ways = surface(face).displacements(frames(face), ofCorners);
            auto way = ways.begin();
            for (int j = 0; j <= steps(); ++j)
                for (int i = 0; i <= steps(); ++i, ++way) {
                    if (!isMovedBy(face, i, j)) continue;
                    const std::size_t number = before_.numbers()(face, i, j);
                    lattice_.move(number, before_.point(number) + point(*way));
                }
        });
    }

    /// A point on an edge is moved by one of the faces that have it.
    [[nodiscard]] bool isMovedBy(FaceId face, int i, int j) const {
        const auto isInside = [&](int k) { return k > 0 && k < steps(); };
        if (isInside(i) && isInside(j)) return true;
        if (!isInside(i) && !isInside(j)) return false; // vertices stay
        HalfedgeId side = mesh_.halfedge_handle(face);
        for (int turns = isInside(i) ? (j == 0 ? 0 : 2) : (i == 0 ? 3 : 1); turns > 0; --turns)
            side = mesh_.next_halfedge_handle(side);
        const EdgeId edge = mesh_.edge_handle(side);
        return side == mesh_.halfedge_handle(edge, 0) || mesh_.is_boundary(edge);
    }

    [[nodiscard]] int steps() const { return before_.squares(); }

    MeshLattice& lattice_;
    const MeshLattice before_;
    const QuadMesh& mesh_;
    unsigned jobs_;
    std::vector<std::optional<TangentFrame>> frames_; ///< by vertex, where the tangent plane may be tilted
};

} // namespace

void minimiseBending(MeshLattice& lattice, const std::vector<VertexRule>& rules, const PlaneCorners& corners,
                     unsigned jobs) {
    MinBending(lattice, rules, corners, jobs).run();
}

} // namespace qm
