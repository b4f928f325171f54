/// \file Free particles, which may always go straight on to the first track (docs/METHOD.md#merging).
#pragma once

#include "enumerate/state/problem.h"

#include <vector>

namespace qm {

/// One of the particles of a line.
struct Particle {
    LineId line;
    bool fromEnd = false; ///< whether it starts at the line's end and walks towards the beginning

    auto operator<=>(const Particle&) const = default; // NOLINT(modernize-use-nullptr): no pointer
};

/// Lets free particles walk on until none is left; next is always the one whose new arcs cost least, and
/// among equal costs the first. When a new track crosses the way of free particles, their walks get shorter;
/// no other walks are computed again.
/// \return the number of particles that have walked on
std::size_t extendCheapestFirst(const ArcGraph& graph, const IdVector<ArcId, double>& arcCosts,
                                PresentArcs& present);

/// The junction where the track of a free particle ends, unfinished as the other line does not pass there
/// (rule 2).
/// \return none if the particle is not free
[[nodiscard]] JunctionId freeEnd(const ArcGraph& graph, Particle particle, const PresentArcs& present);

/// All free particles, ascending.
[[nodiscard]] std::vector<Particle> freeParticles(const ArcGraph& graph, const PresentArcs& present);

} // namespace qm
