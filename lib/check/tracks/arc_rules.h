/// \file The four rules on arcs: is this set of edges a motorcycle graph? (docs/METHOD.md#arc-rules)
///
/// Knows nothing of tracks: a graph that passes here and in track_rules.h has been proved valid twice.
#pragma once

#include "check/tracks/lines.h"

#include <span>
#include <string>
#include <vector>

namespace qm::check {

struct BrokenArcRule {
    const char* rule = ""; ///< "arc rule 1" to "arc rule 4", or "whole arcs"
    std::string explanation;
};

/// The rules that a set of edges must obey.
enum class ArcRuleSet {
    ofGraphs, ///< all four
    ofTMeshes ///< 1 and 2
};

/// \param present  by edge: whether it belongs to the graph
/// \param count    how many edges do
/// \return         all breaches; empty if the set is a motorcycle graph, or a T-mesh. Linear in the network.
[[nodiscard]] std::vector<BrokenArcRule> brokenArcRules(const Neighbourhoods& around,
                                                        const LineNetwork& network,
                                                        std::span<const char> present, std::size_t count,
                                                        ArcRuleSet rules = ArcRuleSet::ofGraphs);

} // namespace qm::check
