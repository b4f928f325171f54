// Refines a mesh: `refine MESH N` splits every quad into N x N on its bilinear surface; `refine MESH smooth`
// makes one step of Catmull-Clark subdivision. Writes OBJ to standard output.
#include "base/at.h"
#include "base/error.h"
#include "mesh/files/read_mesh.h"
#include "mesh/files/write_soup.h"
#include "mesh/soup/build_mesh.h"

#include <array>
#include <charconv>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace {

using qm::at;
using qm::EdgeId;
using qm::FaceId;
using qm::HalfedgeId;
using qm::Point;
using qm::QuadMesh;
using qm::VertexId;

struct Grids {
    std::vector<Point> points; ///< vertices of the mesh, then points on edges, then points inside quads
    std::vector<std::array<int, 4>> quads;
};

class Splitter {
public:
    Splitter(const QuadMesh& mesh, int steps)
        : mesh_(mesh), steps_(steps), edges_(static_cast<int>(mesh.n_vertices())),
          inner_(edges_ + static_cast<int>(mesh.n_edges()) * (steps - 1)) {}

    Grids split() {
        result_.points.resize(at(inner_) + mesh_.n_faces() * at((steps_ - 1) * (steps_ - 1)));
        for (const FaceId face : mesh_.faces())
            splitFace(face);
        return std::move(result_);
    }

private:
    /// The point `k` steps along a halfedge.
    [[nodiscard]] int along(HalfedgeId halfedge, int k) const {
        if (k == 0) return mesh_.from_vertex_handle(halfedge).idx();
        if (k == steps_) return mesh_.to_vertex_handle(halfedge).idx();
        const int place = halfedge.idx() % 2 == 0 ? k : steps_ - k;
        return edges_ + halfedge.idx() / 2 * (steps_ - 1) + place - 1;
    }

    void splitFace(FaceId face) {
        std::array<HalfedgeId, 4> sides;
        HalfedgeId next = mesh_.halfedge_handle(face);
        for (HalfedgeId& side : sides) {
            side = next;
            next = mesh_.next_halfedge_handle(next);
        }
        const auto number = [&](int i, int j) {
            if (j == 0) return along(sides[0], i);
            if (i == steps_) return along(sides[1], j);
            if (j == steps_) return along(sides[2], steps_ - i);
            if (i == 0) return along(sides[3], steps_ - j);
            return inner_ + (face.idx() * (steps_ - 1) + j - 1) * (steps_ - 1) + i - 1;
        };
        std::array<Point, 4> corners;
        for (std::size_t k = 0; k < 4; ++k)
            corners[k] = mesh_.point(mesh_.from_vertex_handle(sides[k]));
        for (int j = 0; j <= steps_; ++j)
            for (int i = 0; i <= steps_; ++i) {
                const double u = static_cast<double>(i) / steps_, v = static_cast<double>(j) / steps_;
                result_.points[at(number(i, j))] = (corners[0] * (1 - u) + corners[1] * u) * (1 - v) +
                                                   (corners[3] * (1 - u) + corners[2] * u) * v;
                if (i < steps_ && j < steps_)
                    result_.quads.push_back(
                        {number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)});
            }
    }

    const QuadMesh& mesh_;
    int steps_;
    int edges_; ///< the first point on an edge
    int inner_; ///< the first point inside a quad
    Grids result_;
};

/// Moves the points of quads split in two to their places under Catmull-Clark subdivision.
void smooth(const QuadMesh& mesh, Grids& grids) {
    const std::size_t vertices = mesh.n_vertices();
    const std::vector<Point> flat = grids.points;
    const auto middle = [&](FaceId face) { return flat[vertices + mesh.n_edges() + at(face.idx())]; };
    for (const EdgeId edge : mesh.edges()) {
        if (mesh.is_boundary(edge)) continue;
        const Point sum = middle(mesh.face_handle(mesh.halfedge_handle(edge, 0))) +
                          middle(mesh.face_handle(mesh.halfedge_handle(edge, 1)));
        grids.points[vertices + at(edge.idx())] = flat[vertices + at(edge.idx())] / 2 + sum / 4;
    }
    for (const VertexId vertex : mesh.vertices()) {
        Point sum(0, 0, 0);
        double count = 0;
        const bool boundary = mesh.is_boundary(vertex);
        for (const EdgeId edge : mesh.ve_range(vertex))
            if (!boundary || mesh.is_boundary(edge)) {
                sum += 2 * flat[vertices + at(edge.idx())];
                ++count;
            }
        Point& point = grids.points[at(vertex.idx())];
        if (count == 0) continue;
        if (boundary) {
            point = point / 2 + sum / (4 * count);
            continue;
        }
        for (const FaceId face : mesh.vf_range(vertex))
            sum += middle(face);
        point = (sum / count + (count - 3) * point) / count;
    }
}

} // namespace

int main(int argc, char** argv) {
    const std::string name = argc == 3 ? argv[1] : "", how = argc == 3 ? argv[2] : "";
    int parts = how == "smooth" ? 2 : 0;
    if (parts == 0) std::from_chars(how.data(), how.data() + how.size(), parts);
    if (parts < 1) {
        std::cerr << "usage: refine MESH N|smooth\n";
        return 2;
    }
    try {
        std::ifstream file(name, std::ios::binary);
        const std::string bytes(std::istreambuf_iterator<char>(file), {});
        const QuadMesh mesh = qm::readMesh(bytes, name).mesh;
        Grids grids = Splitter(mesh, parts).split();
        if (how == "smooth") smooth(mesh, grids);
        std::cout << qm::writeSoup(qm::soupOf(qm::buildMesh(grids.points, grids.quads)), qm::MeshFormat::obj);
        return std::cout.flush() ? 0 : 1;
    } catch (const qm::Error& error) {
        std::cerr << "refine: " << error.what() << '\n';
        return 1;
    }
}
