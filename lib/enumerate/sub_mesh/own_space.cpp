#include "base/sort_unique.h"
#include "base/sparse_id_vector.h"
#include "enumerate/sub_mesh/search_space.h"

#include <utility>

namespace qm {
namespace {

class Extractor {
public:
    Extractor(const SearchSpace& space, SubMeshId subMesh)
        : space_(space), whole_(space.graph), subMesh_(subMesh) {}

    SearchSpace extract() {
        const std::vector<LineId>& lines = linesFrom(space_, subMesh_);
        for (const LineId line : lines)
            addLine(line);
        addJunctions();
        part_.cornerCost = space_.cornerCost;
        for (std::size_t i = 0; i < lines.size(); ++i)
            part_.linesOf[subMesh_].emplace_back(i);
        return std::move(part_);
    }

private:
    void addLine(LineId id) {
        const Line& line = whole_.lines[id];
        ArcGraph& graph = part_.graph;
        const LineId own = graph.lines.nextId();
        graph.lines.push_back(line);
        graph.lines.back().firstArc = graph.arcs.nextId();
        for (const ArcId arc : line.arcs()) {
            arcOf_.at(arc) = graph.arcs.nextId();
            graph.arcs.push_back({own, whole_.arcs[arc].begin, whole_.arcs[arc].end});
            graph.junctionAfter.push_back(whole_.junctionAfter[arc]);
            part_.arcCosts.push_back(space_.arcCosts[arc]);
            part_.arcBegins.push_back(space_.arcBegins[arc]);
            part_.arcEnds.push_back(space_.arcEnds[arc]);
            if (!space_.demands.empty()) part_.demands.push_back(space_.demands[arc]);
        }
    }

    /// Copies the junctions on the copied lines, which refer to junctions of the whole space until then.
    void addJunctions() {
        std::vector<JunctionId> met;
        forEachNamed([&](JunctionId& junction) { met.push_back(junction); });
        sortUnique(met);
        SparseIdVector<JunctionId, JunctionId> junctionOf;
        for (const JunctionId id : met) {
            junctionOf.at(id) = part_.graph.junctions.nextId();
            part_.graph.junctions.push_back(ownJunction(whole_.junctions[id]));
            part_.junctionLabels.push_back(space_.junctionLabels[id]);
        }
        forEachNamed([&](JunctionId& junction) { junction = junctionOf[junction]; });
    }

    template <class Visit> void forEachNamed(const Visit& visit) {
        for (JunctionId& junction : part_.graph.junctionAfter)
            if (junction.valid()) visit(junction);
        for (Line& line : part_.graph.lines)
            for (JunctionId* junction : {&line.beginsAt, &line.endsAt})
                if (junction->valid()) visit(*junction);
    }

    [[nodiscard]] Junction ownJunction(const Junction& junction) const {
        Junction own = junction;
        for (ArcId& arc : own.arcs)
            if (arc.valid()) arc = arcOf_[arc];
        // If only the second of the two lines was copied, it becomes the first.
        if (!own.seeded && !own.arcs[0].valid() && !own.arcs[2].valid()) {
            std::swap(own.arcs[0], own.arcs[1]);
            std::swap(own.arcs[2], own.arcs[3]);
        }
        return own;
    }

    const SearchSpace& space_;
    const ArcGraph& whole_;
    SubMeshId subMesh_;
    SearchSpace part_;
    SparseIdVector<ArcId, ArcId> arcOf_; ///< from arcs of the whole space to those of the copy
};

} // namespace

SearchSpace ownSpace(const SearchSpace& space, SubMeshId subMesh) {
    return Extractor(space, subMesh).extract();
}

} // namespace qm
