#include "bspline/reference/planes/evened_mesh.h"

#include "base/at.h"
#include "base/parallel.h"
#include "base/sort_unique.h"
#include "bspline/reference/lattice/facet_grids.h"
#include "bspline/reference/limit/smooth_continuation.h"
#include "bspline/reference/planes/plane_patches.h"
#include "mesh/quad_geometry.h"
#include "mesh/topology.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace qm {
namespace {

/// By face: the plane of its segment, if that is plane.
std::vector<std::optional<Plane>> planesOfFaces(const QuadMesh& mesh, const Layout& layout,
                                                const SmoothNetwork& network, double flatness) {
    const auto planes = planesOf(facetGrids(mesh, layout), network, flatness);
    std::vector<std::optional<Plane>> ofFaces(mesh.n_faces());
    for (std::size_t k = 0; k < planes.size(); ++k)
        for (const FaceId face : layout.segments[k].faces)
            ofFaces[at(face)] = planes[k];
    return ofFaces;
}

/// A connected part of a plane, within its outermost two rings: no other part has any of its quads.
struct PlanePart {
    Point normal; ///< of the plane, unit
    std::vector<VertexId> inner;
};

class PlaneParts {
public:
    PlaneParts(const QuadMesh& mesh, std::vector<std::optional<Plane>> planes,
               const std::vector<bool>& isCrease)
        : mesh_(mesh), planes_(std::move(planes)), isInPlane_(mesh.n_vertices()),
          isInner_(mesh.n_vertices()) {
        for (const VertexId vertex : mesh_.vertices())
            isInPlane_[at(vertex)] = liesInPlane(vertex, isCrease);
        for (const VertexId vertex : mesh_.vertices())
            isInner_[at(vertex)] = isInPlane(vertex) && !isHub(mesh_, vertex) && allAroundAreInPlane(vertex);
    }

    /// The parts that have vertices within.
    [[nodiscard]] std::vector<PlanePart> all() const {
        std::vector<PlanePart> parts;
        std::vector<bool> isTaken(mesh_.n_vertices());
        for (const VertexId seed : mesh_.vertices()) {
            if (!isInner_[at(seed)] || isTaken[at(seed)]) continue;
            isTaken[at(seed)] = true;
            PlanePart part{planes_[at(*mesh_.cvf_iter(seed))]->normal, {seed}};
            for (std::size_t k = 0; k < part.inner.size(); ++k)
                for (const FaceId face : mesh_.vf_range(part.inner[k]))
                    for (const VertexId corner : mesh_.fv_range(face)) {
                        if (!isInner_[at(corner)] || isTaken[at(corner)]) continue;
                        isTaken[at(corner)] = true;
                        part.inner.push_back(corner);
                    }
            parts.push_back(std::move(part));
        }
        return parts;
    }

private:
    /// Whether the vertex lies neither on the outline of a plane part nor on a crease within it.
    [[nodiscard]] bool isInPlane(VertexId vertex) const { return isInPlane_[at(vertex)]; }

    [[nodiscard]] bool liesInPlane(VertexId vertex, const std::vector<bool>& isCrease) const {
        if (mesh_.is_isolated(vertex) || mesh_.is_boundary(vertex)) return false;
        const std::optional<Plane>& plane = planes_[at(*mesh_.cvf_iter(vertex))];
        return plane &&
               std::ranges::all_of(mesh_.vf_range(vertex),
                                   [&](FaceId face) { return planes_[at(face)] == plane; }) &&
               std::ranges::none_of(mesh_.ve_range(vertex), [&](EdgeId edge) { return isCrease[at(edge)]; });
    }

    [[nodiscard]] bool allAroundAreInPlane(VertexId vertex) const {
        return std::ranges::all_of(mesh_.vf_range(vertex), [&](FaceId face) {
            return std::ranges::all_of(mesh_.fv_range(face),
                                       [&](VertexId corner) { return isInPlane(corner); });
        });
    }

    const QuadMesh& mesh_;
    std::vector<std::optional<Plane>> planes_; ///< by face
    std::vector<bool> isInPlane_;              ///< by vertex
    std::vector<bool> isInner_; ///< by vertex: so are all vertices of its quads, and it is no hub
};

/// Whether lines turn: a vertex is away from the middle of its neighbours by more than a share of the mean
/// distance from them.
bool isUneven(const QuadMesh& mesh, VertexId vertex) {
    constexpr double share = 0.05;
    Point sum(0, 0, 0);
    double distances = 0;
    for (const VertexId beside : mesh.vv_range(vertex)) {
        const Point way = mesh.point(beside) - mesh.point(vertex);
        sum += way;
        distances += way.norm();
    }
    return sum.norm() > share * distances;
}

/// How often a vertex of a part has a quad that is folded, or turned over against most others.
std::size_t wrongQuads(const QuadMesh& mesh, const PlanePart& part) {
    std::array<std::size_t, 2> turned{};
    std::size_t folded = 0;
    for (const VertexId vertex : part.inner)
        for (const FaceId face : mesh.vf_range(vertex)) {
            const auto ofQuad = middleNormal(mesh, face);
            if (!ofQuad || isFolded(mesh, face))
                ++folded;
            else
                ++turned[(*ofQuad | part.normal) > 0 ? 1 : 0];
        }
    return folded + std::ranges::min(turned);
}

/// Where the vertices of a part are to move; nowhere if its quads are even.
std::vector<Point> evened(const QuadMesh& mesh, const std::vector<VertexId>& inner, unsigned jobs) {
    if (std::ranges::none_of(inner, [&](VertexId vertex) { return isUneven(mesh, vertex); })) return {};
    MovingVertices moving;
    for (const VertexId vertex : inner)
        moving.add(vertex);
    std::vector<VertexId> even = inner;
    for (const VertexId vertex : inner)
        for (const VertexId beside : mesh.vv_range(vertex))
            if (!moving.contains(beside) && !isHub(mesh, beside)) even.push_back(beside);
    sortUnique(even);
    return smoothContinuation(mesh, moving, even, jobs).value_or(std::vector<Point>{});
}

/// Moves vertices unless that would turn quads over.
/// \return whether it did
bool move(const PlanePart& part, const std::vector<Point>& points, QuadMesh& mesh) {
    const std::size_t wrongBefore = wrongQuads(mesh, part);
    std::vector<Point> before;
    for (std::size_t k = 0; k < points.size(); ++k) {
        before.push_back(mesh.point(part.inner[k]));
        mesh.set_point(part.inner[k], points[k]);
    }
    if (wrongQuads(mesh, part) <= wrongBefore) return true;
    for (std::size_t k = 0; k < points.size(); ++k)
        mesh.set_point(part.inner[k], before[k]);
    return false;
}

} // namespace

std::optional<QuadMesh> evenedMesh(const QuadMesh& mesh, const Layout& layout, const SmoothNetwork& network,
                                   double flatness, unsigned jobs) {
    const std::vector<PlanePart> parts =
        PlaneParts(mesh, planesOfFaces(mesh, layout, network, flatness), network.marks.isCrease).all();
    std::vector<std::vector<Point>> points(parts.size());
    const unsigned jobsEach =
        std::max(1U, jobs / static_cast<unsigned>(std::max<std::size_t>(1, parts.size())));
    parallelFor(parts.size(), jobs,
                [&](std::size_t k) { points[k] = evened(mesh, parts[k].inner, jobsEach); });
    std::optional<QuadMesh> result;
    bool hasMoved = false;
    for (std::size_t k = 0; k < parts.size(); ++k) {
        if (points[k].empty()) continue;
        if (!result) result = mesh;
        hasMoved = move(parts[k], points[k], *result) || hasMoved;
    }
    return hasMoved ? std::move(result) : std::nullopt;
}

} // namespace qm
