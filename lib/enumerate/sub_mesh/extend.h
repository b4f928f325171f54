/// \file Going straight on until the first track: always a valid end for a particle (docs/METHOD.md#merging).
#pragma once

#include "enumerate/state/problem.h"

#include <vector>

namespace qm {

/// One of the particles of a line.
struct Particle {
    LineId line;
    bool fromEnd = false; ///< it starts at the line's end and walks towards its beginning

    bool operator==(const Particle&) const = default;
    bool operator<(const Particle& other) const {
        return line == other.line ? fromEnd < other.fromEnd : line < other.line;
    }
};

/// Walks the particle on from where its track ends: to the first junction where both arcs of the crossing
/// line are present, to its opposite's track, to the end of its line, or over an arc into an open junction.
/// \param present  of every arc; changed
/// \param open     junctions where the walk may end unfinished
/// \return the arcs added
int extendParticle(const ArcGraph& graph, Particle particle, std::vector<bool>& present,
                   const OpenJunctions& open = {});

/// Walks the free particles on until none is left, always the one whose new arcs cost the least, of equal
/// ones the first. Walks of particles that a new track crosses get shorter; no others are looked at again.
/// \return how many were walked on
std::size_t extendCheapestFirst(const ArcGraph& graph, const std::vector<double>& arcCosts,
                                std::vector<bool>& present);

/// Whether the particle's track ends unfinished: at a junction that is not passed by the other line (rule 2).
[[nodiscard]] bool isFree(const ArcGraph& graph, Particle particle, const std::vector<bool>& present);

/// The particles whose tracks end unfinished.
[[nodiscard]] std::vector<Particle> freeParticles(const ArcGraph& graph, const std::vector<bool>& present);

/// The junction where the particle's track ends; invalid at the line's far end or before its first arc.
[[nodiscard]] JunctionId crashJunction(const ArcGraph& graph, Particle particle,
                                       const std::vector<bool>& present);

} // namespace qm
