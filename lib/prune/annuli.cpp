#include "prune/annuli.h"

#include "base/at.h"
#include "base/sort_unique.h"
#include "base/sparse_disjoint_sets.h"
#include "mesh/mesh_lines.h"
#include "mesh/topology.h"

namespace qm {
namespace {

/// Maximal strips of quads, each joined to the next across opposite edges. Every edge lies across one strip.
class Strips {
public:
    explicit Strips(const QuadMesh& mesh) : mesh_(mesh), stripOf_(mesh.n_edges(), none) {
        for (const EdgeId edge : mesh.edges())
            if (stripOf_[at(edge)] == none) walk(edge);
        for (const FaceId face : mesh.faces()) {
            const HalfedgeId first = mesh.halfedge_handle(face);
            const std::size_t along = across(first), other = across(mesh.next_halfedge_handle(first));
            if (along == other) closed_[along] = false; // a strip that crosses itself lies in no annulus
        }
    }

    [[nodiscard]] std::size_t size() const { return edges_.size(); }
    [[nodiscard]] bool isClosed(std::size_t strip) const { return closed_[strip]; }
    [[nodiscard]] const std::vector<EdgeId>& edges(std::size_t strip) const { return edges_[strip]; }
    /// The strip that crosses an edge.
    [[nodiscard]] std::size_t across(HalfedgeId halfedge) const {
        return stripOf_[at(mesh_.edge_handle(halfedge))];
    }

private:
    static constexpr std::size_t none = static_cast<std::size_t>(-1);

    void walk(EdgeId edge) {
        edges_.emplace_back();
        const HalfedgeId start = mesh_.halfedge_handle(edge, 0);
        closed_.push_back(walkFrom(start));
        if (!closed_.back()) (void)walkFrom(mesh_.opposite_halfedge_handle(start));
    }

    /// \return whether the walk returned to its start
    bool walkFrom(HalfedgeId start) {
        HalfedgeId entering = start;
        do {
            take(mesh_.edge_handle(entering));
            if (mesh_.is_boundary(entering)) return false;
            entering = acrossQuad(mesh_, entering);
        } while (entering != start);
        return true;
    }

    void take(EdgeId edge) {
        if (stripOf_[at(edge)] != none) return; // the edge in the middle of an open strip is met twice
        stripOf_[at(edge)] = edges_.size() - 1;
        edges_.back().push_back(edge);
    }

    const QuadMesh& mesh_;
    std::vector<std::size_t> stripOf_;
    std::vector<std::vector<EdgeId>> edges_;
    std::vector<bool> closed_;
};

class Bands {
public:
    Bands(const QuadMesh& mesh, const std::vector<ArcId>& arcOf)
        : mesh_(mesh), arcOf_(arcOf), strips_(mesh), endless_(strips_.size(), false) {}

    AnnulusBands find() {
        std::vector<Side> sides;
        forEachMeshLine(mesh_, [&](const MeshLine& line) {
            if (!line.closed) return;
            const Side side = sideOf(line);
            if (!strips_.isClosed(side.strips[0]) || !strips_.isClosed(side.strips[1])) return;
            side.arcs.empty() ? unite(side.strips) : sides.push_back(side);
        });
        std::vector<std::size_t> bandOf(strips_.size());
        AnnulusBands bands;
        for (std::size_t strip = 0; strip < strips_.size(); ++strip)
            if (strips_.isClosed(strip) && root(strip) == strip && !endless_[strip]) {
                bandOf[strip] = bands.across.size();
                bands.across.push_back(arcsOver(strips_.edges(strip)));
            }
        for (Side& side : sides)
            bands.joints.push_back(
                {{bandOf[root(side.strips[0])], bandOf[root(side.strips[1])]}, std::move(side.arcs)});
        return bands;
    }

private:
    /// The strips on both sides of a closed line, and the arcs on the line.
    struct Side {
        std::array<std::size_t, 2> strips{};
        std::vector<ArcId> arcs;
    };

    [[nodiscard]] Side sideOf(const MeshLine& line) const {
        const HalfedgeId one = line.halfedges.front(), other = mesh_.opposite_halfedge_handle(one);
        std::vector<EdgeId> edges;
        for (const HalfedgeId halfedge : line.halfedges)
            edges.push_back(mesh_.edge_handle(halfedge));
        return {{strips_.across(mesh_.next_halfedge_handle(one)),
                 strips_.across(mesh_.next_halfedge_handle(other))},
                arcsOver(edges)};
    }

    [[nodiscard]] std::vector<ArcId> arcsOver(const std::vector<EdgeId>& edges) const {
        std::vector<ArcId> arcs;
        for (const EdgeId edge : edges)
            if (arcOf_[at(edge)].valid()) arcs.push_back(arcOf_[at(edge)]);
        sortUnique(arcs);
        return arcs;
    }

    std::size_t root(std::size_t strip) { return at(bands_.find(static_cast<int>(strip))); }

    /// Joins two strips that nothing ever separates. A band joined to itself in this way goes round a torus.
    void unite(const std::array<std::size_t, 2>& strips) {
        const std::size_t one = root(strips[0]), other = root(strips[1]);
        endless_[one] = endless_[one] || endless_[other] || one == other;
        bands_.join(static_cast<int>(other), static_cast<int>(one));
    }

    const QuadMesh& mesh_;
    const std::vector<ArcId>& arcOf_;
    Strips strips_;
    SparseDisjointSets bands_;  ///< of strips
    std::vector<bool> endless_; ///< for the root of every band: it goes round a torus
};

} // namespace

AnnulusBands annulusBands(const QuadMesh& mesh, const std::vector<ArcId>& arcOf) {
    return Bands(mesh, arcOf).find();
}

} // namespace qm
