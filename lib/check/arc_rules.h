/// \file The four rules on arcs: is this set of edges a motorcycle graph? (docs/METHOD.md#arc-rules)
///
/// Knows nothing of tracks: a graph that passes here and in track_rules.h has been proved valid twice.
#pragma once

#include "check/lines.h"

#include <span>
#include <string>
#include <vector>

namespace qm::check {

struct BrokenArcRule {
    const char* rule = ""; ///< "arc rule 1" to "arc rule 4", or "whole arcs"
    std::string explanation;
};

/// \param present  by edge: whether it belongs to the graph
/// \param count    how many edges do
/// \param tmesh    whether rules 1 and 2 alone are asked for
/// \return         all breaches; empty if the set is a motorcycle graph. Linear in the network.
[[nodiscard]] std::vector<BrokenArcRule> brokenArcRules(const Neighbourhoods& around,
                                                        const LineNetwork& network,
                                                        std::span<const char> present, std::size_t count,
                                                        bool tmesh = false);

} // namespace qm::check
