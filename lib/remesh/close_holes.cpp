#include "remesh/close_holes.h"

#include "base/at.h"
#include "base/infinity.h"
#include "bspline/reference/scan/triangle_surface.h"
#include "mesh/boundary_loops.h"
#include "mesh/quad_geometry.h"
#include "mesh/soup/build_mesh.h"
#include "mesh/topology.h"
#include "mesh/triangles/triangle_edges.h"

#include <algorithm>
#include <array>
#include <queue>
#include <unordered_map>
#include <utility>
#include <vector>

namespace qm {
namespace {

constexpr std::size_t maxEdges = 8; // of a hole
/// Cost of a turn of a row, in quads: it makes two extraordinary vertices.
constexpr int costOfTurn = 8;

class HoleCloser {
public:
    explicit HoleCloser(QuadMesh mesh) : mesh_(std::move(mesh)) {}

    QuadMesh run(const Triangles& scan) {
        fillHoles(scan);
        for (int k = 0; k < static_cast<int>(mesh_.n_faces()); ++k)
            if (const FaceId face(k); isTriangle(face))
                if (const auto row = cheapestRow(face); !row.empty()) divide(row);
        return quadsAlone();
    }

private:
    [[nodiscard]] HalfedgeId next(HalfedgeId halfedge) const { return mesh_.next_halfedge_handle(halfedge); }
    [[nodiscard]] HalfedgeId opposite(HalfedgeId halfedge) const {
        return mesh_.opposite_halfedge_handle(halfedge);
    }

    // ---- filling

    void fillHoles(const Triangles& scan) {
        std::vector<std::vector<VertexId>> holes;
        for (const std::vector<HalfedgeId>& path : boundaryPaths(mesh_)) {
            if (path.size() > maxEdges) continue;
            std::vector<VertexId>& hole = holes.emplace_back();
            for (const HalfedgeId halfedge : path)
                hole.push_back(mesh_.from_vertex_handle(halfedge));
        }
        if (!holes.empty() && boundaryLoopCount(scan) > 0) {
            const TriangleSurface surface(scan);
            std::erase_if(holes,
                          [&](const auto& hole) { return surface.nearest(middleOf(hole))->onBoundary; });
        }
        for (const auto& hole : holes)
            cutIntoQuads(mesh_.add_face(hole));
    }

    [[nodiscard]] Point middleOf(const std::vector<VertexId>& vertices) const {
        Point middle(0, 0, 0);
        for (const VertexId vertex : vertices)
            middle += mesh_.point(vertex) / static_cast<double>(vertices.size());
        return middle;
    }

    /// Cuts off a quad by the shortest line, again and again, until at most a triangle remains.
    void cutIntoQuads(FaceId face) {
        while (face.is_valid() && mesh_.valence(face) > 4) {
            double shortest = infinity;
            HalfedgeId first;
            for (const HalfedgeId halfedge : mesh_.fh_range(face)) {
                const VertexId from = mesh_.from_vertex_handle(halfedge);
                const VertexId to = mesh_.to_vertex_handle(next(next(halfedge)));
                const double length = (mesh_.point(to) - mesh_.point(from)).norm();
                if (!(length < shortest) || mesh_.find_halfedge(from, to).is_valid()) continue;
                shortest = length;
                first = halfedge;
            }
            if (!first.is_valid()) return; // it would make a second edge between two vertices
            const HalfedgeId cut =
                mesh_.insert_edge(mesh_.prev_halfedge_handle(first), next(next(next(first))));
            const FaceId left = mesh_.face_handle(cut), right = mesh_.face_handle(opposite(cut));
            face = left == mesh_.face_handle(first) ? right : left;
        }
    }

    // ---- rows

    [[nodiscard]] bool isTriangle(FaceId face) const { return face.is_valid() && mesh_.valence(face) == 3; }

    /// The cheapest row of quads from a triangle to another, or to the boundary.
    /// \return the side of the triangle and those by which the row leaves each quad; none if there is no row
    [[nodiscard]] std::vector<HalfedgeId> cheapestRow(FaceId triangle) const {
        using Place = std::pair<int, HalfedgeId>; // cost so far, and the side of the face that comes next
        const auto isLater = [](const Place& a, const Place& b) {
            return std::pair(a.first, a.second.idx()) > std::pair(b.first, b.second.idx());
        };
        std::priority_queue<Place, std::vector<Place>, decltype(isLater)> places(isLater);
        std::unordered_map<int, std::pair<int, HalfedgeId>> reached; // by entry: cost, and the entry before
        const auto reach = [&](HalfedgeId exit, int cost, HalfedgeId before) {
            const HalfedgeId entry = opposite(exit);
            const auto [known, isNew] = reached.try_emplace(entry.idx(), cost, before);
            if (!isNew && known->second.first <= cost) return;
            known->second = {cost, before};
            places.emplace(cost, entry);
        };
        for (const HalfedgeId side : mesh_.fh_range(triangle))
            reach(side, 0, HalfedgeId());
        while (!places.empty()) {
            const auto [cost, entry] = places.top();
            places.pop();
            if (cost > reached.at(entry.idx()).first) continue;
            const FaceId face = mesh_.face_handle(entry);
            if (mesh_.is_boundary(entry) || (isTriangle(face) && face != triangle)) {
                std::vector<HalfedgeId> row;
                for (HalfedgeId at = entry; at.is_valid(); at = reached.at(at.idx()).second)
                    row.push_back(opposite(at));
                std::ranges::reverse(row);
                return withoutLoops(row);
            }
            if (mesh_.valence(face) != 4) continue;
            reach(next(entry), cost + costOfTurn, entry);
            reach(next(next(entry)), cost + 1, entry);
            reach(mesh_.prev_halfedge_handle(entry), cost + costOfTurn, entry);
        }
        return {};
    }

    /// Where a row comes to a quad again, it leaves it the first time as it would the last time.
    [[nodiscard]] std::vector<HalfedgeId> withoutLoops(const std::vector<HalfedgeId>& row) const {
        std::unordered_map<int, std::size_t> lastExit; // of every face of the row
        for (std::size_t k = 0; k < row.size(); ++k)
            lastExit[mesh_.face_handle(row[k]).idx()] = k;
        std::vector<HalfedgeId> simple;
        for (std::size_t k = 0; k < row.size(); ++k) {
            k = lastExit.at(mesh_.face_handle(row[k]).idx());
            simple.push_back(row[k]);
        }
        return simple;
    }

    /// Halves the quads of a row, and the sides by which it enters and leaves them, which makes quads of the
    /// triangles at its ends.
    void divide(const std::vector<HalfedgeId>& row) {
        // Known before any side is halved: what is opposite changes then.
        struct Pass {
            FaceId face;
            int sides = 0; ///< from where the row enters it to where it leaves it
        };
        std::vector<Pass> passes;
        for (std::size_t k = 1; k < row.size(); ++k) {
            HalfedgeId side = opposite(row[k - 1]);
            passes.push_back({mesh_.face_handle(side)});
            for (; side != row[k]; side = next(side))
                ++passes.back().sides;
        }
        VertexId entry = halved(mesh_.edge_handle(row[0]));
        for (std::size_t k = 1; k < row.size(); ++k) {
            const auto& [face, sides] = passes[k - 1];
            const VertexId exit = halved(mesh_.edge_handle(row[k]));
            if (sides == 2)
                connect(entry, exit, face);
            else if (sides == 1)
                connectAroundCorner(entry, exit, face);
            else
                connectAroundCorner(exit, entry, face);
            entry = exit;
        }
    }

    /// Divides a hexagon between two points with one corner between them: from either of them to the corner
    /// beyond the other, whichever is shorter.
    void connectAroundCorner(VertexId first, VertexId second, FaceId face) {
        const VertexId before = mesh_.from_vertex_handle(halfedgeTo(first, face));
        const VertexId after = mesh_.to_vertex_handle(next(halfedgeTo(second, face)));
        const auto length = [this](VertexId a, VertexId b) {
            return (mesh_.point(a) - mesh_.point(b)).norm();
        };
        if (length(before, second) <= length(first, after))
            connect(before, second, face);
        else
            connect(first, after, face);
    }

    void connect(VertexId a, VertexId b, FaceId face) {
        mesh_.insert_edge(halfedgeTo(a, face), next(halfedgeTo(b, face)));
    }

    VertexId halved(EdgeId edge) {
        const auto [from, to] = endsOf(mesh_, edge);
        const VertexId middle = mesh_.add_vertex((mesh_.point(from) + mesh_.point(to)) / 2);
        mesh_.split_edge(edge, middle);
        return middle;
    }

    [[nodiscard]] HalfedgeId halfedgeTo(VertexId vertex, FaceId face) const {
        HalfedgeId halfedge = mesh_.halfedge_handle(face);
        while (mesh_.to_vertex_handle(halfedge) != vertex)
            halfedge = next(halfedge);
        return halfedge;
    }

    [[nodiscard]] QuadMesh quadsAlone() const {
        std::vector<Point> points;
        for (const VertexId vertex : mesh_.vertices())
            points.push_back(mesh_.point(vertex));
        std::vector<std::array<int, 4>> quads;
        for (const FaceId face : mesh_.faces()) {
            if (mesh_.valence(face) != 4) continue;
            const auto [a, b, c, d] = cornersOf(mesh_, face);
            quads.push_back({a.idx(), b.idx(), c.idx(), d.idx()});
        }
        return buildMesh(points, quads);
    }

    QuadMesh mesh_; ///< which has other polygons meanwhile
};

} // namespace

QuadMesh closeHoles(QuadMesh mesh, const Triangles& scan) {
    return HoleCloser(std::move(mesh)).run(scan);
}

} // namespace qm
