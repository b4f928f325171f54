/// \file What is known before a search, of arcs and of the junctions past a cut.
#pragma once

#include "base/ids.h"

#include <span>
#include <unordered_set>
#include <vector>

namespace qm {

/// What is known of an arc before a search.
enum class ArcState : signed char { out = 0, in = 1, free = -1 };

/// Of all arcs, in memory that depends on the free ones only.
class ArcStates {
public:
    /// All arcs are free.
    ArcStates() = default;
    /// Some are free, every other one is as it is in a graph.
    /// \param present  of every arc; outlives this
    ArcStates(const std::vector<bool>& present, std::span<const ArcId> freeArcs)
        : present_(&present), free_(freeArcs.begin(), freeArcs.end()) {}

    [[nodiscard]] ArcState operator[](ArcId arc) const {
        if (present_ == nullptr || free_.contains(arc)) return ArcState::free;
        return (*present_)[arc.idx()] ? ArcState::in : ArcState::out;
    }

private:
    const std::vector<bool>* present_ = nullptr;
    std::unordered_set<ArcId> free_;
};

/// The junctions where tracks may end unfinished: those outside a sub-mesh.
class OpenJunctions {
public:
    /// There are none.
    OpenJunctions() = default;
    /// \param labels  the sub-mesh of every junction; outlives this
    OpenJunctions(const std::vector<SubMeshId>& labels, SubMeshId subMesh)
        : labels_(&labels), subMesh_(subMesh) {}

    [[nodiscard]] bool contains(JunctionId junction) const {
        return labels_ != nullptr && (*labels_)[junction.idx()] != subMesh_;
    }

private:
    const std::vector<SubMeshId>* labels_ = nullptr;
    SubMeshId subMesh_;
};

} // namespace qm
