#include "bspline/reference/improvement/evened_mesh.h"

#include "base/at.h"
#include "base/parallel.h"
#include "bspline/reference/improvement/smooth_continuation.h"
#include "bspline/reference/planes/plane_parts.h"
#include "mesh/quad_geometry.h"
#include "mesh/topology.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace qm {
namespace {

/// A connected part of a plane, within its outermost two rings: no other part has any of its quads.
struct InnerPart {
    Point normal; ///< of the plane, unit
    std::vector<VertexId> vertices;
};

class InnerParts {
public:
    InnerParts(const QuadMesh& mesh, PlaneParts parts, const std::vector<bool>& isCrease)
        : mesh_(mesh), parts_(std::move(parts)), isInPlane_(mesh.n_vertices()), isInner_(mesh.n_vertices()) {
        for (const VertexId vertex : mesh_.vertices())
            isInPlane_[at(vertex)] = partAround(mesh_, parts_, isCrease, vertex) != PlaneParts::none;
        for (const VertexId vertex : mesh_.vertices())
            isInner_[at(vertex)] =
                isInPlane_[at(vertex)] && !isHub(mesh_, vertex) && allAroundAreInPlane(vertex);
    }

    /// The parts that have vertices within.
    [[nodiscard]] std::vector<InnerPart> all() const {
        std::vector<InnerPart> result;
        std::vector<bool> isTaken(mesh_.n_vertices());
        for (const VertexId seed : mesh_.vertices()) {
            if (!isInner_[at(seed)] || isTaken[at(seed)]) continue;
            isTaken[at(seed)] = true;
            InnerPart part{parts_.planes[at(parts_.ofFace[at(*mesh_.cvf_iter(seed))])].normal, {seed}};
            for (std::size_t k = 0; k < part.vertices.size(); ++k)
                for (const FaceId face : mesh_.vf_range(part.vertices[k]))
                    for (const VertexId corner : mesh_.fv_range(face)) {
                        if (!isInner_[at(corner)] || isTaken[at(corner)]) continue;
                        isTaken[at(corner)] = true;
                        part.vertices.push_back(corner);
                    }
            result.push_back(std::move(part));
        }
        return result;
    }

private:
    [[nodiscard]] bool allAroundAreInPlane(VertexId vertex) const {
        return std::ranges::all_of(mesh_.vf_range(vertex), [&](FaceId face) {
            return std::ranges::all_of(mesh_.fv_range(face),
                                       [&](VertexId corner) { return isInPlane_[at(corner)]; });
        });
    }

    const QuadMesh& mesh_;
    PlaneParts parts_;
    std::vector<bool> isInPlane_; ///< by vertex: neither on a part's outline nor on a crease
    std::vector<bool> isInner_;   ///< by vertex: so are all vertices of its quads, and it is no hub
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
std::size_t wrongQuads(const QuadMesh& mesh, const InnerPart& part) {
    std::array<std::size_t, 2> turned{};
    std::size_t folded = 0;
    for (const VertexId vertex : part.vertices)
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
    const auto counts = [&](VertexId beside) { return !isHub(mesh, beside); };
    return smoothContinuation(mesh, moving, counts, jobs).value_or(std::vector<Point>{});
}

/// Moves vertices unless that would turn quads over.
/// \return whether it did
bool move(const InnerPart& part, const std::vector<Point>& points, QuadMesh& mesh) {
    const std::size_t wrongBefore = wrongQuads(mesh, part);
    const std::vector<Point> before = pointsOf(mesh, part.vertices);
    setPoints(mesh, part.vertices, points);
    if (wrongQuads(mesh, part) <= wrongBefore) return true;
    setPoints(mesh, part.vertices, before);
    return false;
}

} // namespace

std::optional<QuadMesh> evenedMesh(const QuadMesh& mesh, const std::vector<bool>& isCrease, double flatness,
                                   unsigned jobs) {
    const std::vector<InnerPart> parts =
        InnerParts(mesh, planeParts(mesh, isCrease, flatness, jobs), isCrease).all();
    std::vector<std::vector<Point>> points(parts.size());
    const unsigned jobsEach =
        std::max(1U, jobs / static_cast<unsigned>(std::max<std::size_t>(1, parts.size())));
    parallelFor(parts.size(), jobs,
                [&](std::size_t k) { points[k] = evened(mesh, parts[k].vertices, jobsEach); });
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
