/// \file Rules A1 to A4: are these coordinates valid tracks? (docs/METHOD.md#valid-tracks)
#pragma once

#include "check/tracks/lines.h"

#include <span>
#include <string>
#include <vector>

namespace qm::check {

struct BrokenTrackRule {
    const char* rule = ""; ///< "A1" to "A4"
    int way = -1;          ///< the way whose track breaks it
    std::string explanation;
};

/// \param coordinates  of every way: how many arcs its particle walked, 0 to the way's length
/// \return             all breaches, ordered by way; empty if the tracks are valid. Linear in the network.
[[nodiscard]] std::vector<BrokenTrackRule> brokenTrackRules(const LineNetwork& network,
                                                            std::span<const int> coordinates);

} // namespace qm::check
