#include "bspline/network/creases.h"

#include <cstddef>
#include <optional>
#include <utility>

namespace qm {
namespace {

/// Above this dihedral angle, in radians, a crease may end anywhere.
constexpr double certain = 1.0;

/// Longer curves may end anywhere, too.
constexpr std::size_t maxEdges = 4;

class Creases {
public:
    Creases(const QuadMesh& mesh, const std::vector<double>& dihedralAngles, std::vector<bool> isCrease)
        : mesh_(mesh), angles_(dihedralAngles), isCrease_(std::move(isCrease)) {}

    std::vector<bool> withoutLooseEnds() {
        std::vector<VertexId> waiting(mesh_.vertices_begin(), mesh_.vertices_end());
        while (!waiting.empty()) {
            const VertexId vertex = waiting.back();
            waiting.pop_back();
            // What remains at the curve's other end may be a loose end now.
            if (const auto end = takeBackFrom(vertex)) waiting.push_back(*end);
        }
        return std::move(isCrease_);
    }

private:
    static std::size_t index(EdgeId edge) { return static_cast<std::size_t>(edge.idx()); }

    /// The only crease that leaves a vertex beside one that arrives, if there is one and no more.
    [[nodiscard]] HalfedgeId onlyCrease(VertexId vertex, HalfedgeId arriving) const {
        HalfedgeId only;
        for (const HalfedgeId halfedge : mesh_.voh_range(vertex)) {
            const bool isBack =
                arriving.is_valid() && mesh_.edge_handle(halfedge) == mesh_.edge_handle(arriving);
            if (isBack || !isCrease_[index(mesh_.edge_handle(halfedge))]) continue;
            if (only.is_valid()) return HalfedgeId();
            only = halfedge;
        }
        return only;
    }

    /// \return the other end of the curve that was taken back
    std::optional<VertexId> takeBackFrom(VertexId vertex) {
        std::vector<EdgeId> curve;
        VertexId end = vertex;
        for (HalfedgeId next = onlyCrease(vertex, HalfedgeId()); next.is_valid();
             next = onlyCrease(end, next)) {
            const EdgeId edge = mesh_.edge_handle(next);
            if (curve.size() == maxEdges || mesh_.is_boundary(edge) || angles_[index(edge)] > certain)
                return std::nullopt;
            curve.push_back(edge);
            end = mesh_.to_vertex_handle(next);
        }
        if (curve.empty()) return std::nullopt;
        for (const EdgeId edge : curve)
            isCrease_[index(edge)] = false;
        return end;
    }

    const QuadMesh& mesh_;
    const std::vector<double>& angles_;
    std::vector<bool> isCrease_;
};

} // namespace

std::vector<bool> findCreases(const QuadMesh& mesh, const std::vector<BorderEdge>& borders,
                              const std::vector<double>& dihedralAngles, double rho) {
    std::vector<bool> isCrease(mesh.n_edges());
    for (const BorderEdge& border : borders) {
        const auto edge = static_cast<std::size_t>(mesh.edge_handle(border.halfedge).idx());
        isCrease[edge] = border.places.size() != 2 || dihedralAngles[edge] > rho;
    }
    return Creases(mesh, dihedralAngles, std::move(isCrease)).withoutLooseEnds();
}

} // namespace qm
