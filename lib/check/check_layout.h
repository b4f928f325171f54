/// \file Is this layout true: its tracks, their cost, its segments? (docs/METHOD.md#layout)
#pragma once

#include "check/context.h"
#include "check/lines.h"
#include "check/report.h"

namespace qm::check {

/// Straight from the merge the tracks must be a motorcycle graph, by both sets of rules. The tracks
/// of a pruned layout run straight, from and to wherever the segments allow. In a component without sources
/// the tracks make up one whole mesh line. Transversals run straight from one track or boundary to another
/// and cost nothing.
///
/// \param network  the lines of the whole mesh, with the feature seeds
void checkLayout(const Context& context, const LineNetwork& network, const LayoutPart& part, Report& report);

} // namespace qm::check
