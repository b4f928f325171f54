#include "prune/annuli.h"

#include "base/at.h"
#include "base/id_vector.h"
#include "base/sort_unique.h"
#include "base/sparse_disjoint_sets.h"
#include "mesh/mesh_lines.h"
#include "mesh/topology.h"

namespace qm {
namespace {

using StripId = Id<struct StripTag>;

/// Maximal strips of quads, each joined to the next across opposite edges. Every edge lies across one strip.
class Strips {
public:
    explicit Strips(const QuadMesh& mesh) : mesh_(mesh), stripOf_(mesh.n_edges()) {
        for (const EdgeId edge : mesh.edges())
            if (!stripOf_[at(edge)].valid()) walk(edge);
        for (const FaceId face : mesh.faces()) {
            const HalfedgeId first = mesh.halfedge_handle(face);
            const StripId along = across(first), other = across(mesh.next_halfedge_handle(first));
            if (along == other) closed_[along] = false; // a strip that crosses itself lies in no annulus
        }
    }

    [[nodiscard]] IdRange<StripId> ids() const { return edges_.ids(); }
    [[nodiscard]] std::size_t size() const { return edges_.size(); }
    [[nodiscard]] bool isClosed(StripId strip) const { return closed_[strip]; }
    [[nodiscard]] const std::vector<EdgeId>& edges(StripId strip) const { return edges_[strip]; }
    /// The strip that crosses an edge.
    [[nodiscard]] StripId across(HalfedgeId halfedge) const {
        return stripOf_[at(mesh_.edge_handle(halfedge))];
    }

private:
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
        if (stripOf_[at(edge)].valid()) return; // the edge in the middle of an open strip is met twice
        stripOf_[at(edge)] = edges_.nextId() - 1;
        edges_.back().push_back(edge);
    }

    const QuadMesh& mesh_;
    std::vector<StripId> stripOf_; ///< by edge
    IdVector<StripId, std::vector<EdgeId>> edges_;
    IdVector<StripId, bool> closed_;
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
        IdVector<StripId, std::size_t> bandOf(strips_.size());
        AnnulusBands bands;
        for (const StripId strip : strips_.ids())
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
        std::array<StripId, 2> strips;
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

    StripId root(StripId strip) { return StripId(bands_.find(strip.value())); }

    /// Joins two strips that nothing ever separates. A band joined to itself in this way goes round a torus.
    void unite(const std::array<StripId, 2>& strips) {
        const StripId one = root(strips[0]), other = root(strips[1]);
        endless_[one] = endless_[one] || endless_[other] || one == other;
        bands_.join(other.value(), one.value());
    }

    const QuadMesh& mesh_;
    const std::vector<ArcId>& arcOf_;
    Strips strips_;
    SparseDisjointSets bands_;        ///< of strips
    IdVector<StripId, bool> endless_; ///< for the root of every band: it goes round a torus
};

} // namespace

AnnulusBands annulusBands(const QuadMesh& mesh, const std::vector<ArcId>& arcOf) {
    return Bands(mesh, arcOf).find();
}

} // namespace qm
