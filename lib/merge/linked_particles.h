/// \file The particles that a search of the complete generator may move: free particles and those linked to
/// them (docs/METHOD.md#merging, CMG).
#pragma once

#include "enumerate/sub_mesh/extend.h"
#include "enumerate/sub_mesh/search_space.h"

#include <vector>

namespace qm {

/// The arcs of one sub-mesh that a search may change.
struct LinkedParticles {
    std::vector<ArcId> arcs;
    std::size_t linked = 0;     ///< lines of particles that are not free
    double quasiComplexity = 0; ///< sum of log2(candidate stops) over the lines
};

/// Which linked particles are included.
enum class Linking {
    closed, ///< all whose tracks a movable particle may cross, or that crash on its track, and so on
    direct, ///< only those whose tracks a free particle may cross
    none    ///< none; all other tracks are walls
};

/// \param particles  free particles whose crash points lie in the sub-mesh
[[nodiscard]] LinkedParticles linkedParticles(const SearchSpace& space, const PresentArcs& present,
                                              const std::vector<Particle>& particles, SubMeshId subMesh,
                                              Linking linking);

} // namespace qm
