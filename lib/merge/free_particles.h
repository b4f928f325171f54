/// \file The free particles of a layout that changes, by the sub-mesh where they wait
/// (docs/METHOD.md#merging).
#pragma once

#include "enumerate/sub_mesh/extend.h"
#include "enumerate/sub_mesh/search_space.h"

#include <set>
#include <unordered_map>
#include <vector>

namespace qm {

class FreeParticles {
public:
    /// Both arguments outlive this.
    FreeParticles(const SearchSpace& space, const std::vector<bool>& present);

    /// Those whose tracks end in a sub-mesh, by line, the one from its beginning first.
    [[nodiscard]] const std::set<Particle>& in(SubMeshId subMesh) const;
    [[nodiscard]] std::size_t count() const { return count_; }

    /// Looks again at the particles that arcs which have come or gone can concern: those of their lines and
    /// of the lines across.
    void update(const std::vector<ArcId>& changed);

private:
    void place(Particle particle);
    /// The sub-mesh where it waits, or none.
    [[nodiscard]] SubMeshId subMeshOf(Particle particle) const;

    const SearchSpace& space_;
    const std::vector<bool>& present_;
    std::unordered_map<SubMeshId, std::set<Particle>> waiting_; ///< by sub-mesh
    std::vector<SubMeshId> placeOf_;                            ///< of the two particles of every line
    std::size_t count_ = 0;
};

} // namespace qm
