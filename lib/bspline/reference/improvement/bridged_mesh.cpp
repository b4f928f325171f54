#include "bspline/reference/improvement/bridged_mesh.h"

#include "base/at.h"
#include "bspline/reference/improvement/smooth_continuation.h"
#include "bspline/reference/lattice/bilinear_quad.h"
#include "bspline/reference/lattice/sound_faces.h"
#include "mesh/quad_geometry.h"
#include "mesh/topology.h"

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

class Bridging {
public:
    Bridging(const QuadMesh& mesh, const std::vector<bool>& isCrease)
        : mesh_(mesh), isFolded_(mesh.n_faces()), isFixed_(mesh.n_vertices()) {
        for (const FaceId face : mesh_.faces())
            isFolded_[at(face)] = qm::isFolded(mesh_, face);
        for (const EdgeId edge : mesh_.edges()) {
            const HalfedgeId halfedge = mesh_.halfedge_handle(edge, 0);
            const auto isBesideFold = [&](HalfedgeId side) {
                return !mesh_.is_boundary(side) && isFolded_[at(mesh_.face_handle(side))] &&
                       !isFlat(mesh_.face_handle(side));
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
    /// Only of quads that are not folded.
    [[nodiscard]] Point normalOf(FaceId face) const { return *middleNormal(mesh_, face); }

    /// Whether a quad has one normal everywhere, however flat a corner is: creases beside it are real.
    [[nodiscard]] bool isFlat(FaceId face) const {
        return BilinearQuad(cornerPoints(mesh_, face)).minCosine() > nearlyFlat;
    }

    [[nodiscard]] bool isFixed(VertexId vertex) const { return isFixed_[at(vertex)]; }

    /// No crease passes, and the quads around that are not folded lie on one side of a smooth surface.
    [[nodiscard]] bool mayMove(VertexId vertex) const {
        if (isFixed(vertex) || isHub(mesh_, vertex)) return false;
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
        std::vector<Point> best; // of those that moved first
        std::ptrdiff_t gain = 0;
        moved_ = {};
        for (const VertexId vertex : mesh_.fv_range(face))
            take(vertex);
        if (moved_.all().empty()) return false;
        for (int ring = 0; ring <= maxRings; ++ring) {
            if (ring > 0) grow();
            const std::vector<Point> before = pointsOf(mesh_, moved_.all());
            const auto points = smoothContinuation(
                mesh_, moved_, [&](VertexId beside) { return mayMove(beside); }, 1);
            if (!points) break;
            const auto wrongBefore = wrongQuads();
            setPoints(mesh_, moved_.all(), *points);
            const auto wrong = wrongQuads();
            setPoints(mesh_, moved_.all(), before);
            if (wrongBefore - wrong > gain) {
                gain = wrongBefore - wrong;
                best = *points;
            }
            if (wrong == 0) break;
        }
        setPoints(mesh_, moved_.all(), best);
        for (std::size_t k = 0; k < best.size(); ++k)
            for (const FaceId beside : mesh_.vf_range(moved_.all()[k]))
                isFolded_[at(beside)] = qm::isFolded(mesh_, beside);
        return gain > 0;
    }

    void take(VertexId vertex) {
        if (!moved_.contains(vertex) && mayMove(vertex)) moved_.add(vertex);
    }

    void grow() {
        for (const VertexId vertex : std::vector<VertexId>(moved_.all()))
            for (const FaceId face : mesh_.vf_range(vertex))
                for (const VertexId other : mesh_.fv_range(face))
                    take(other);
    }

    /// How many quads at the vertices that move are folded, or turned over against one beside them.
    [[nodiscard]] std::ptrdiff_t wrongQuads() const {
        const auto agrees = [&](HalfedgeId side) {
            if (isFixed(mesh_.from_vertex_handle(side)) && isFixed(mesh_.to_vertex_handle(side))) return true;
            const FaceId beside = mesh_.opposite_face_handle(side);
            return qm::isFolded(mesh_, beside) || (normalOf(mesh_.face_handle(side)) | normalOf(beside)) > 0;
        };
        const auto isUpright = [&](FaceId face) {
            return !qm::isFolded(mesh_, face) && std::ranges::all_of(mesh_.fh_range(face), agrees);
        };
        std::set<FaceId> wrong;
        for (const VertexId vertex : moved_.all())
            for (const FaceId face : mesh_.vf_range(vertex))
                if (!isUpright(face)) wrong.insert(face);
        return std::ssize(wrong);
    }

    QuadMesh mesh_;
    std::vector<bool> isFolded_; ///< by face
    std::vector<bool> isFixed_;  ///< by vertex: a crease or the boundary passes
    MovingVertices moved_;       ///< with the fold that is being bridged, ring by ring
};

} // namespace

std::optional<QuadMesh> bridgedMesh(const QuadMesh& mesh, const std::vector<bool>& isCrease) {
    if (std::ranges::none_of(mesh.faces(), [&](FaceId face) { return isFolded(mesh, face); })) return {};
    return Bridging(mesh, isCrease).run();
}

} // namespace qm
