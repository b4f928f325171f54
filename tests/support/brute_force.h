/// \file All motorcycle graphs of a small mesh by trying all coordinates: the yardstick for the search.
#pragma once

#include "check/angles.h"
#include "check/lines.h"

#include <cstdint>
#include <limits>
#include <map>
#include <vector>

namespace qm::testing {

struct BruteForce {
    struct Graph {
        double cost = 0;              ///< G_T
        std::vector<int> coordinates; ///< of every way: the first vector that was found for this graph
    };
    std::map<std::vector<int>, Graph> graphs; ///< by their edges, ascending
    /// Valid coordinate vectors, up to who walks each line without junctions: every such line with two
    /// sources doubles the number of vectors and changes nothing else.
    std::uint64_t vectors = 0;
    int uncrossedLines = 0; ///< how many lines there are of that kind
    bool complete = true;   ///< the limit has not ended the search
};

/// Depth first over the coordinates, in the plain words of rules A1 to A4 (docs/METHOD.md#valid-tracks). For
/// small meshes only: the time grows with the number of valid vectors.
/// \param maxSteps  of the search, then it ends
[[nodiscard]] BruteForce bruteForce(const check::Neighbourhoods& around, const check::LineNetwork& network,
                                    const check::EdgeCosts& costs,
                                    std::uint64_t maxSteps = std::numeric_limits<std::uint64_t>::max());

} // namespace qm::testing
