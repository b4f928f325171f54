#include "remesh/unfold_quads.h"

#include "base/at.h"
#include "base/sort_unique.h"
#include "mesh/quad_geometry.h"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

namespace qm {
namespace {

/// Quads that are less upright are worked at: corners below 12 or above 168 degrees.
constexpr double hardlyUpright = 0.2;
/// Smaller gains are not worth a movement, so that these end.
constexpr double minGain = 1e-3;
/// Nearly all has been done after four; some places gain for longer.
constexpr int maxSweeps = 30;
/// How far a vertex goes to a mean of its neighbours; beyond it where others have to make room.
constexpr std::array<double, 4> shares{1, 0.5, 0.2, 1.5};

class Unfolding {
public:
    Unfolding(QuadMesh& mesh, const TriangleSurface& scan, double reach)
        : mesh_(mesh), scan_(scan), reach_(reach) {
        for (const FaceId face : mesh.faces())
            uprightness_.push_back(uprightness(mesh, face, scan, reach));
    }

    void run() {
        std::vector<VertexId> vertices(mesh_.vertices_begin(), mesh_.vertices_end());
        for (int sweep = 0; sweep < maxSweeps && !vertices.empty(); ++sweep) {
            std::vector<VertexId> moved;
            for (const VertexId vertex : vertices)
                if (improve(vertex)) moved.push_back(vertex);
            vertices = around(moved);
        }
    }

private:
    [[nodiscard]] double worstAround(VertexId vertex) const {
        double worst = 1;
        for (const FaceId face : mesh_.vf_range(vertex))
            worst = std::min(worst, uprightness_[at(face)]);
        return worst;
    }

    void measureAround(VertexId vertex) {
        for (const FaceId face : mesh_.vf_range(vertex))
            uprightness_[at(face)] = uprightness(mesh_, face, scan_, reach_);
    }

    /// Means of the neighbours, and of all vertices of the quads around; on the boundary of those along it.
    [[nodiscard]] std::vector<Point> goals(VertexId vertex) const {
        const bool onBoundary = mesh_.is_boundary(vertex);
        std::vector<VertexId> neighbours;
        for (const HalfedgeId halfedge : mesh_.voh_range(vertex))
            if (!onBoundary || mesh_.is_boundary(mesh_.edge_handle(halfedge)))
                neighbours.push_back(mesh_.to_vertex_handle(halfedge));
        if (onBoundary) return {mean(neighbours)};
        std::vector<VertexId> all;
        for (const FaceId face : mesh_.vf_range(vertex))
            for (const VertexId corner : mesh_.fv_range(face))
                if (corner != vertex) all.push_back(corner);
        return {mean(neighbours), mean(all)};
    }

    [[nodiscard]] Point mean(const std::vector<VertexId>& vertices) const {
        Point sum{0, 0, 0};
        for (const VertexId vertex : vertices)
            sum += mesh_.point(vertex);
        return sum / static_cast<double>(vertices.size());
    }

    /// \return whether the vertex has moved
    bool improve(VertexId vertex) {
        if (mesh_.is_isolated(vertex)) return false;
        const double before = worstAround(vertex);
        if (before > hardlyUpright) return false;
        const Point from = mesh_.point(vertex);
        double best = before + minGain;
        Point to = from;
        for (const Point& goal : goals(vertex))
            for (const double share : shares) {
                const auto foot = scan_.nearest(from + share * (goal - from), reach_);
                if (!foot || (mesh_.is_boundary(vertex) && !foot->onBoundary)) continue;
                mesh_.set_point(vertex, foot->position);
                measureAround(vertex);
                if (const double now = worstAround(vertex); now > best) {
                    best = now;
                    to = foot->position;
                }
            }
        mesh_.set_point(vertex, to);
        measureAround(vertex);
        return to != from;
    }

    /// Vertices of the quads around some vertices, ascending.
    [[nodiscard]] std::vector<VertexId> around(const std::vector<VertexId>& moved) const {
        std::vector<VertexId> vertices;
        for (const VertexId vertex : moved)
            for (const FaceId face : mesh_.vf_range(vertex))
                for (const VertexId corner : mesh_.fv_range(face))
                    vertices.push_back(corner);
        sortUnique(vertices);
        return vertices;
    }

    QuadMesh& mesh_;
    const TriangleSurface& scan_;
    double reach_;
    std::vector<double> uprightness_; ///< by face
};

} // namespace

double uprightness(const QuadMesh& mesh, FaceId face, const TriangleSurface& scan, double reach) {
    const std::optional<Point> normal = middleNormal(mesh, face);
    if (!normal) return -1;
    const double sine = *minCornerSine(mesh, face);
    Point middle{0, 0, 0};
    for (const VertexId corner : cornersOf(mesh, face))
        middle += mesh.point(corner) / 4;
    const auto foot = scan.nearest(middle, reach);
    return foot ? std::min(sine, scan.cosineAt(*foot, *normal)) : sine;
}

void unfoldQuads(QuadMesh& mesh, const TriangleSurface& scan, double reach) {
    Unfolding(mesh, scan, reach).run();
}

} // namespace qm
