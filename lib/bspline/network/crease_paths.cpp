#include "bspline/network/crease_paths.h"

#include "base/at.h"

#include <algorithm>
#include <iterator>
#include <optional>

namespace qm {
namespace {

class PathSearch {
public:
    PathSearch(const QuadMesh& mesh, const BorderMarks& marks) : mesh_(mesh), isUnvisited_(marks.isCrease) {
        for (const EdgeId edge : mesh.edges())
            if (mesh.is_boundary(edge)) isUnvisited_[at(edge)] = false;
        creases_.resize(mesh.n_vertices());
        for (const EdgeId edge : mesh.edges())
            if (isUnvisited_[at(edge)])
                for (const unsigned end : {0U, 1U})
                    ++creases_[at(mesh.to_vertex_handle(mesh.halfedge_handle(edge, end)))];
    }

    std::vector<std::vector<VertexId>> run() {
        std::vector<std::vector<VertexId>> paths;
        for (const EdgeId edge : mesh_.edges()) {
            if (!isUnvisited_[at(edge)]) continue;
            isUnvisited_[at(edge)] = false;
            std::vector<VertexId> path = onFrom(mesh_.halfedge_handle(edge, 1));
            std::ranges::reverse(path);
            std::ranges::move(onFrom(mesh_.halfedge_handle(edge, 0)), std::back_inserter(path));
            paths.push_back(std::move(path));
        }
        return paths;
    }

private:
    /// The vertices after the first of a crease, which is taken.
    std::vector<VertexId> onFrom(HalfedgeId first) {
        std::vector<VertexId> vertices;
        for (std::optional<HalfedgeId> next = first; next; next = after(vertices.back())) {
            isUnvisited_[at(mesh_.edge_handle(*next))] = false;
            vertices.push_back(mesh_.to_vertex_handle(*next));
        }
        return vertices;
    }

    [[nodiscard]] std::optional<HalfedgeId> after(VertexId vertex) const {
        if (creases_[at(vertex)] != 2) return std::nullopt;
        for (const HalfedgeId halfedge : mesh_.voh_range(vertex))
            if (isUnvisited_[at(mesh_.edge_handle(halfedge))]) return halfedge;
        return std::nullopt;
    }

    const QuadMesh& mesh_;
    std::vector<bool> isUnvisited_; ///< by edge: creases of no path yet
    std::vector<int> creases_;      ///< by vertex, how many meet
};

} // namespace

std::vector<std::vector<VertexId>> creasePaths(const QuadMesh& mesh, const BorderMarks& marks) {
    return PathSearch(mesh, marks).run();
}

} // namespace qm
