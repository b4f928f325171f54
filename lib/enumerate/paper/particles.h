/// \file Particles, their candidate stops, and who else arrives there: the setting of A1 to A4
/// (docs/METHOD.md#valid-tracks).
#pragma once

#include "enumerate/state/assignment.h"

#include <vector>

namespace qm {

/// Where another particle arrives at a stop, on its own coordinate; particle -1 if none does.
struct Arrival {
    int particle = -1;
    int coordinate = 0;
};

/// A candidate stop strictly between the ends of a particle's way.
struct Stop {
    Arrival left;
    Arrival right;
    bool wall =
        false; ///< the crossing line is there in every graph and nobody can pass: stopping is always right
    bool crossed = false; ///< a line crosses; otherwise nothing can stop here except head-on
};

/// A particle on a chain. Its coordinate counts variables from its source.
struct CoordinateParticle {
    int chain = 0;
    bool fromEnd = false;
    int length = 0;
    int opposite = -1;
    int least = 0; ///< bounds that the domains give
    int most = 0;
    std::vector<Stop> stops; ///< at coordinates 1 .. length - 1, so stops[c - 1] is at c
};

[[nodiscard]] std::vector<CoordinateParticle> coordinateParticles(const Problem& problem);

/// The arcs that particles at these coordinates have walked.
[[nodiscard]] Assignment assignmentOf(const Problem& problem,
                                      const std::vector<CoordinateParticle>& particles,
                                      const std::vector<int>& coordinates);

/// A1 to A4.
[[nodiscard]] bool validCoordinates(const std::vector<CoordinateParticle>& particles,
                                    const std::vector<int>& coordinates);

} // namespace qm
