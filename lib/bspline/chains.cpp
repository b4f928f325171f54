#include "bspline/chains.h"

#include "mesh/topology.h"

#include <algorithm>

namespace qm {
namespace {

/// For every halfedge of a border edge, the one that follows it in its chain; invalid where the chain ends.
class Successors {
public:
    explicit Successors(const QuadMesh& mesh) : mesh_(mesh), next_(mesh.n_halfedges()) {}

    void join(HalfedgeId first, HalfedgeId second) {
        set(first, second);
        set(mesh_.opposite_halfedge_handle(second), mesh_.opposite_halfedge_handle(first));
    }
    [[nodiscard]] HalfedgeId operator[](HalfedgeId halfedge) const { return next_[index(halfedge)]; }

private:
    static std::size_t index(HalfedgeId halfedge) { return static_cast<std::size_t>(halfedge.idx()); }
    void set(HalfedgeId from, HalfedgeId to) { next_[index(from)] = to; }

    const QuadMesh& mesh_;
    std::vector<HalfedgeId> next_;
};

/// The border's halfedges as each patch walks them, by patch and side.
using SideHalfedges = std::vector<std::array<std::vector<HalfedgeId>, 4>>;

SideHalfedges sideHalfedges(const QuadMesh& mesh, const Layout& layout,
                            const std::vector<BorderEdge>& borders) {
    SideHalfedges sides(layout.segments.size());
    for (std::size_t s = 0; s < sides.size(); ++s)
        for (std::size_t k = 0; k < 4; ++k)
            sides[s][k].resize(layout.segments[s].sides[k].size() - 1);
    for (const BorderEdge& border : borders)
        for (std::size_t p = 0; p < border.places.size(); ++p) {
            const BorderPlace& place = border.places[p];
            sides[place.patch][static_cast<std::size_t>(place.side)]
                 [static_cast<std::size_t>(place.position)] =
                     p == 0 ? border.halfedge : mesh.opposite_halfedge_handle(border.halfedge);
        }
    return sides;
}

} // namespace

Chains::Chains(const QuadMesh& mesh, const Layout& layout)
    : mesh_(&mesh), chainOf_(mesh.n_edges(), -1), positionOf_(mesh.n_edges(), 0) {
    trace(borderEdges(mesh, layout), layout);
}

void Chains::trace(const std::vector<BorderEdge>& borders, const Layout& layout) {
    const auto sides = sideHalfedges(*mesh_, layout, borders);
    Successors next(*mesh_);
    for (const auto& ofPatch : sides)
        for (const auto& side : ofPatch)
            for (std::size_t k = 0; k + 1 < side.size(); ++k)
                if (isRegular(*mesh_, mesh_->to_vertex_handle(side[k]))) next.join(side[k], side[k + 1]);

    for (const BorderEdge& border : borders) {
        if (isBorder(mesh_->edge_handle(border.halfedge))) continue;
        BorderChain chain;
        HalfedgeId first = border.halfedge;
        while (true) {
            const HalfedgeId before = next[mesh_->opposite_halfedge_handle(first)];
            if (!before.is_valid()) break;
            first = mesh_->opposite_halfedge_handle(before);
            if (first == border.halfedge) {
                chain.closed = true;
                break;
            }
        }
        for (HalfedgeId h = first; h.is_valid() && !isBorder(mesh_->edge_handle(h)); h = next[h]) {
            const auto edge = static_cast<std::size_t>(mesh_->edge_handle(h).idx());
            chainOf_[edge] = static_cast<std::ptrdiff_t>(chains_.size());
            positionOf_[edge] = chain.length();
            chain.halfedges.push_back(h);
        }
        chains_.push_back(std::move(chain));
    }

    pieces_.resize(sides.size());
    for (std::size_t s = 0; s < sides.size(); ++s)
        for (std::size_t k = 0; k < 4; ++k)
            for (const HalfedgeId h : sides[s][k]) {
                auto& pieces = pieces_[s][k];
                const ChainPlace at = place(h);
                const bool goesOn = !pieces.empty() && pieces.back().place.chain == at.chain &&
                                    pieces.back().place.way == at.way &&
                                    pieces.back().place.position + pieces.back().length == at.position;
                if (goesOn)
                    ++pieces.back().length;
                else
                    pieces.push_back({at, 1});
            }
}

ChainPlace Chains::place(HalfedgeId halfedge) const {
    const auto edge = static_cast<std::size_t>(mesh_->edge_handle(halfedge).idx());
    const auto chain = static_cast<std::size_t>(chainOf_[edge]);
    const int position = positionOf_[edge];
    if (chains_[chain].halfedges[static_cast<std::size_t>(position)] == halfedge) return {chain, 0, position};
    return {chain, 1, chains_[chain].length() - 1 - position};
}

HalfedgeId Chains::halfedge(const ChainPlace& place) const {
    const BorderChain& chain = chains_[place.chain];
    if (place.way == 0) return chain.halfedges[static_cast<std::size_t>(place.position)];
    return mesh_->opposite_halfedge_handle(
        chain.halfedges[static_cast<std::size_t>(chain.length() - 1 - place.position)]);
}

bool Chains::hasPatch(std::size_t chain, int way) const {
    return !mesh_->is_boundary(halfedge({chain, way, 0}));
}

} // namespace qm
