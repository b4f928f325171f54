/// \file What a search of the complete generator may change: free particles and those linked to them
/// (docs/METHOD.md#merging, CMG).
#pragma once

#include "enumerate/sub_mesh/extend.h"
#include "enumerate/sub_mesh/search_space.h"

#include <vector>

namespace qm {

/// The arcs of one sub-mesh that a search may change.
struct LinkedParticles {
    std::vector<ArcId> arcs;
    std::size_t linked = 0;     ///< lines of particles that are not free themselves
    double quasiComplexity = 0; ///< sum over the lines of log2(candidate stops)
};

/// How far the closure goes.
enum class Linking {
    closed, ///< all particles whose tracks a movable one may cross or that crash on its track, and so on
    direct, ///< only those whose tracks a free particle may cross
    none    ///< free particles alone, all other tracks are walls
};

/// \param particles  free, with their crash points in the sub-mesh
[[nodiscard]] LinkedParticles linkedParticles(const SearchSpace& space, const std::vector<bool>& present,
                                              const std::vector<Particle>& particles, SubMeshId subMesh,
                                              Linking linking);

} // namespace qm
