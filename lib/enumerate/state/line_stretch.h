/// \file The stretch of a line that is left to decide: all its free arcs, and what comes before and after
/// them (docs/METHOD.md#search-problem).
#pragma once

#include "enumerate/state/problem.h"

#include <vector>

namespace qm {

/// Arcs `first` to `last` of a line, counted from its beginning.
struct LineStretch {
    int first = 0;
    int last = -1;
    bool beforeIn = false;       ///< the arc before it is in, or a source is there
    bool beforeAnchored = false; ///< all arcs before it are in, from a source
    bool afterIn = false;        ///< likewise after it, from the line's end
    bool afterAnchored = false;
};

/// From the first free arc to the last. Two, where both particles of the line can only meet at one place,
/// which neither gets past; none, where no arc is free.
[[nodiscard]] std::vector<LineStretch> stretchesOf(const ProblemInput& input, LineId line);

/// What rule 1, what lies beyond the stretch, and the demands leave an arc.
/// \param position  of the arc on the line, in the stretch
/// \throw Error  if that is nothing
[[nodiscard]] ArcState domainOf(const ProblemInput& input, LineId line, const LineStretch& stretch,
                                int position);

/// Makes a domain smaller.
/// \param arc     whose domain it is, for the message
/// \param demand  `free` demands nothing
/// \throw Error  if nothing is left
void restrictDomain(const ArcGraph& graph, ArcId arc, ArcState& domain, ArcState demand);

} // namespace qm
