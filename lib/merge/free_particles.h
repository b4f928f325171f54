/// \file The free particles of a changing layout, by the sub-mesh where their tracks end
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
    /// Both arguments must outlive this.
    FreeParticles(const SearchSpace& space, const PresentArcs& present);

    /// The free particles whose tracks end in a sub-mesh, ordered by line, the one from its beginning first.
    [[nodiscard]] const std::set<Particle>& in(SubMeshId subMesh) const;
    [[nodiscard]] std::size_t count() const { return count_; }

    /// Examines again the particles that changed arcs may affect: those on the arcs' own lines and on the
    /// lines that cross them.
    void update(const std::vector<ArcId>& changed);

private:
    void place(Particle particle);

    const SearchSpace& space_;
    const PresentArcs& present_;
    std::unordered_map<SubMeshId, std::set<Particle>> waiting_; ///< by sub-mesh
    std::vector<SubMeshId> placeOf_; ///< sub-mesh where both particles of every line wait
    std::size_t count_ = 0;
};

} // namespace qm
