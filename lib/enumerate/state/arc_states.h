/// \file What is known before a search about arcs, and about junctions beyond the cut.
#pragma once

#include "base/id_vector.h"
#include "basecomplex/arc_graph.h"

#include <span>
#include <unordered_set>

namespace qm {

/// What is known about an arc before a search.
enum class ArcState : signed char { out = 0, in = 1, free = -1 };

[[nodiscard]] constexpr ArcState arcState(bool isIn) {
    return isIn ? ArcState::in : ArcState::out;
}

/// The states of all arcs, in memory that is linear in the number of free arcs.
class ArcStates {
public:
    /// All arcs are free.
    ArcStates() = default;
    /// Some arcs are free; every other arc is fixed to what it is in a graph.
    /// \param present  the arcs of the graph; must outlive this
    ArcStates(const PresentArcs& present, std::span<const ArcId> freeArcs)
        : present_(&present), free_(freeArcs.begin(), freeArcs.end()) {}

    [[nodiscard]] ArcState operator[](ArcId arc) const {
        if (present_ == nullptr || free_.contains(arc)) return ArcState::free;
        return arcState((*present_)[arc]);
    }

private:
    const PresentArcs* present_ = nullptr;
    std::unordered_set<ArcId> free_;
};

/// The junctions where tracks may end unfinished: all that lie outside a sub-mesh.
class OpenJunctions {
public:
    /// No junction is open.
    OpenJunctions() = default;
    /// \param labels  the sub-mesh of every junction; must outlive this
    OpenJunctions(const IdVector<JunctionId, SubMeshId>& labels, SubMeshId subMesh)
        : labels_(&labels), subMesh_(subMesh) {}

    [[nodiscard]] bool contains(JunctionId junction) const {
        return labels_ != nullptr && (*labels_)[junction] != subMesh_;
    }

private:
    const IdVector<JunctionId, SubMeshId>* labels_ = nullptr;
    SubMeshId subMesh_;
};

} // namespace qm
