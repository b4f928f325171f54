/// \file All motorcycle graphs of a small mesh, found by trying all coordinates; the search is compared with
/// them.
#pragma once

#include "check/mesh/angles.h"
#include "check/tracks/lines.h"

#include <cstdint>
#include <limits>
#include <map>
#include <vector>

namespace qm::test {

struct BruteForce {
    struct Graph {
        double cost = 0;              ///< G_T
        std::vector<int> coordinates; ///< of every way; the first vector found for this graph
    };
    std::map<std::vector<int>, Graph> graphs; ///< by their edges, ascending
    /// The number of valid coordinate vectors. Lines with two sources but without junctions are walked by one
    /// particle only, because each of them would double the number and change nothing else.
    std::uint64_t vectors = 0;
    int uncrossedLines = 0; ///< the number of such lines
    bool complete = true;   ///< the search was not ended by the limit
};

/// Searches depth first over the coordinates, by a direct transcription of rules A1 to A4
/// (docs/METHOD.md#valid-tracks). For small meshes only: time grows with the number of valid vectors.
/// \param maxSteps  limit of the search
[[nodiscard]] BruteForce bruteForce(const check::Neighbourhoods& around, const check::LineNetwork& network,
                                    const check::EdgeCosts& costs,
                                    std::uint64_t maxSteps = std::numeric_limits<std::uint64_t>::max());

} // namespace qm::test
