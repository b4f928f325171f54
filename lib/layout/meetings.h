/// \file Where the two particles of a line meet head-on, so that every crossing has its crack
/// (docs/METHOD.md#cracks).
#pragma once

#include "basecomplex/arc_graph.h"
#include "layout/walkers.h"

namespace qm {

/// At a crossing whose four arcs are all present, one of the two lines must be cracked (rule 4): its
/// particles meet there. A line is cracked at one crossing at most.
/// \param present  the arcs of a valid graph
/// \param walkers  which particles take part
/// \return for every line, the arc after which its particles meet; none if they need not meet
[[nodiscard]] IdVector<LineId, ArcId> headOnMeetings(const ArcGraph& graph, const PresentArcs& present,
                                                     const Walkers& walkers);

} // namespace qm
