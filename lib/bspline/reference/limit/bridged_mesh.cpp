#include "bspline/reference/limit/bridged_mesh.h"

#include "base/at.h"
#include "base/sort_unique.h"
#include "bspline/splines/eigen_point.h"
#include "mesh/quad_geometry.h"
#include "mesh/topology.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <set>

namespace qm {
namespace {

/// Smallest cosine of the angle between the normals around a fold and their mean: 50 degrees if a crease is
/// near, because one may continue under the fold; otherwise 78, because coarse meshes turn that much.
constexpr double minCosineNearCreases = 0.64;
constexpr double minCosine = 0.2;
/// Largest number of rings of vertices around a fold that are moved with it.
constexpr int maxRings = 3;
/// A vertex of more quads stays: it lies where many of them have it, and moving it for each would take a time
/// quadratic in their number.
constexpr unsigned maxValence = 32;

class Bridging {
public:
    Bridging(const QuadMesh& mesh, const std::vector<bool>& isCrease)
        : mesh_(mesh), isFolded_(mesh.n_faces()), isFixed_(mesh.n_vertices()), isHub_(mesh.n_vertices()),
          unknown_(mesh.n_vertices(), none) {
        for (const VertexId vertex : mesh_.vertices())
            isHub_[at(vertex)] = mesh_.valence(vertex) > maxValence;
        for (const FaceId face : mesh_.faces())
            isFolded_[at(face)] = qm::isFolded(mesh_, face);
        for (const EdgeId edge : mesh_.edges()) {
            const HalfedgeId halfedge = mesh_.halfedge_handle(edge, 0);
            const auto isBesideFold = [&](HalfedgeId side) {
                return !mesh_.is_boundary(side) && isFolded_[at(mesh_.face_handle(side))];
            };
            const bool isHidden =
                isBesideFold(halfedge) || isBesideFold(mesh_.opposite_halfedge_handle(halfedge));
            if (!mesh_.is_boundary(edge) && (!isCrease[at(edge)] || isHidden)) continue;
            for (const VertexId end : endsOf(mesh_, halfedge))
                isFixed_[at(end)] = true;
        }
    }

    std::optional<QuadMesh> run() {
        bool hasMoved = false;
        for (const FaceId face : mesh_.faces())
            if (isFolded_[at(face)]) hasMoved = bridge(face) || hasMoved;
        if (!hasMoved) return {};
        return std::move(mesh_);
    }

private:
    static constexpr int none = -1;

    /// Only of quads that are not folded.
    [[nodiscard]] Point normalOf(FaceId face) const { return *middleNormal(mesh_, face); }

    [[nodiscard]] bool isFixed(VertexId vertex) const { return isFixed_[at(vertex)]; }

    /// No crease passes, and the quads around that are not folded lie on one side of a smooth surface.
    [[nodiscard]] bool mayMove(VertexId vertex) const {
        if (isFixed(vertex) || isHub_[at(vertex)]) return false;
        double limit = minCosine;
        Point sum(0, 0, 0);
        std::vector<Point> normals;
        for (const FaceId face : mesh_.vf_range(vertex)) {
            if (std::ranges::any_of(mesh_.fv_range(face), [&](VertexId other) { return isFixed(other); }))
                limit = minCosineNearCreases;
            if (isFolded_[at(face)]) continue;
            normals.push_back(normalOf(face));
            sum += normals.back();
        }
        return std::ranges::all_of(normals,
                                   [&](const Point& normal) { return (normal | sum) >= limit * sum.norm(); });
    }

    /// Moves a fold's vertices, and more and more of those around it, until no quad is folded there, or else
    /// as few as can be had.
    bool bridge(FaceId face) {
        std::vector<VertexId> moved;
        std::vector<Point> best;
        std::ptrdiff_t gain = 0;
        for (const VertexId vertex : mesh_.fv_range(face))
            take(vertex, moved);
        if (moved.empty()) return false;
        for (int ring = 0; ring <= maxRings; ++ring) {
            if (ring > 0) grow(moved);
            const std::vector<Point> before = pointsOf(moved);
            const auto wrongBefore = wrongAt(moved);
            if (!continueSmoothly(moved)) break;
            const auto wrong = wrongAt(moved);
            if (wrongBefore - wrong > gain) {
                gain = wrongBefore - wrong;
                best = pointsOf(moved);
            }
            setPoints(moved, before);
            if (wrong == 0) break;
        }
        setPoints(moved, best);
        for (const VertexId vertex : moved)
            unknown_[at(vertex)] = none;
        for (std::size_t k = 0; k < best.size(); ++k)
            for (const FaceId beside : mesh_.vf_range(moved[k]))
                isFolded_[at(beside)] = qm::isFolded(mesh_, beside);
        return gain > 0;
    }

    void take(VertexId vertex, std::vector<VertexId>& moved) {
        if (unknown_[at(vertex)] != none || !mayMove(vertex)) return;
        unknown_[at(vertex)] = static_cast<int>(moved.size());
        moved.push_back(vertex);
    }

    void grow(std::vector<VertexId>& moved) {
        for (const VertexId vertex : std::vector<VertexId>(moved))
            for (const FaceId face : mesh_.vf_range(vertex))
                for (const VertexId other : mesh_.fv_range(face))
                    take(other, moved);
    }

    [[nodiscard]] std::vector<Point> pointsOf(const std::vector<VertexId>& vertices) const {
        std::vector<Point> points(vertices.size());
        std::ranges::transform(vertices, points.begin(),
                               [&](VertexId vertex) { return mesh_.point(vertex); });
        return points;
    }

    /// The first of these vertices, which are taken ring by ring.
    void setPoints(const std::vector<VertexId>& vertices, const std::vector<Point>& points) {
        for (std::size_t k = 0; k < points.size(); ++k)
            mesh_.set_point(vertices[k], points[k]);
    }

    /// How many quads at these vertices are folded, or turned over against one beside them.
    [[nodiscard]] std::ptrdiff_t wrongAt(const std::vector<VertexId>& vertices) const {
        const auto agrees = [&](HalfedgeId side) {
            if (isFixed(mesh_.from_vertex_handle(side)) && isFixed(mesh_.to_vertex_handle(side))) return true;
            const FaceId beside = mesh_.opposite_face_handle(side);
            return qm::isFolded(mesh_, beside) || (normalOf(mesh_.face_handle(side)) | normalOf(beside)) > 0;
        };
        const auto isUpright = [&](FaceId face) {
            return !qm::isFolded(mesh_, face) && std::ranges::all_of(mesh_.fh_range(face), agrees);
        };
        std::set<FaceId> wrong;
        for (const VertexId vertex : vertices)
            for (const FaceId face : mesh_.vf_range(vertex))
                if (!isUpright(face)) wrong.insert(face);
        return std::ssize(wrong);
    }

    /// Least squares of the differences between vertices and the mean of their neighbours, at all vertices
    /// that move and those beside them: a thin plate through what stays.
    bool continueSmoothly(const std::vector<VertexId>& moved) {
        std::vector<VertexId> rows = moved;
        for (const VertexId vertex : moved)
            for (const VertexId beside : mesh_.vv_range(vertex))
                if (unknown_[at(beside)] == none && mayMove(beside)) rows.push_back(beside);
        sortUnique(rows);
        std::vector<Eigen::Triplet<double>> entries;
        Eigen::MatrixX3d constants = Eigen::MatrixX3d::Zero(static_cast<Eigen::Index>(rows.size()), 3);
        for (int row = 0; const VertexId vertex : rows) {
            const auto add = [&](VertexId of, double weight) {
                if (const int column = unknown_[at(of)]; column != none)
                    entries.emplace_back(row, column, weight);
                else
                    constants.row(row) -= weight * vector(mesh_.point(of)).transpose();
            };
            add(vertex, 1);
            const double share = 1.0 / mesh_.valence(vertex);
            for (const VertexId beside : mesh_.vv_range(vertex))
                add(beside, -share);
            ++row;
        }
        Eigen::SparseMatrix<double> matrix(constants.rows(), static_cast<Eigen::Index>(moved.size()));
        matrix.setFromTriplets(entries.begin(), entries.end());
        const Eigen::SparseMatrix<double> transposed = matrix.transpose();
        const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(transposed * matrix);
        if (solver.info() != Eigen::Success) return false;
        const Eigen::MatrixX3d solution = solver.solve(transposed * constants);
        if (!solution.allFinite()) return false;
        for (std::size_t k = 0; k < moved.size(); ++k)
            mesh_.set_point(moved[k], point(solution.row(static_cast<Eigen::Index>(k))));
        return true;
    }

    QuadMesh mesh_;
    std::vector<bool> isFolded_; ///< by face
    std::vector<bool> isFixed_;  ///< by vertex: a crease or the boundary passes
    std::vector<bool> isHub_;    ///< by vertex: it belongs to very many quads
    std::vector<int> unknown_;   ///< by vertex: its number among those that move, or none
};

} // namespace

std::optional<QuadMesh> bridgedMesh(const QuadMesh& mesh, const std::vector<bool>& isCrease) {
    if (std::ranges::none_of(mesh.faces(), [&](FaceId face) { return isFolded(mesh, face); })) return {};
    return Bridging(mesh, isCrease).run();
}

} // namespace qm
