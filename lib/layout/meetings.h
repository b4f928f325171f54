/// \file Where the two particles of a line meet head-on, so that crossings have their cracks
/// (docs/METHOD.md#cracks).
#pragma once

#include "basecomplex/arc_graph.h"
#include "layout/walkers.h"

#include <vector>

namespace qm {

/// At a crossing whose four arcs are all present one of the two lines must crack (rule 4): its particles meet
/// there. A line is given to one crossing at most.
/// \param present  of every arc: a valid graph
/// \param walkers  which particles take part
/// \return of every line, the arc after which its particles meet; invalid where they need not
[[nodiscard]] std::vector<ArcId> headOnMeetings(const ArcGraph& graph, const std::vector<bool>& present,
                                                const Walkers& walkers);

} // namespace qm
