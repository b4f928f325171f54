/// \file The undecided stretch of a line: all its free arcs, and what is known before and after them
/// (docs/METHOD.md#search-problem).
#pragma once

#include "enumerate/state/problem.h"

#include <vector>

namespace qm {

/// The arcs `first` to `last` of a line, counted from its beginning.
struct LineStretch {
    int first = 0;
    int last = -1;
    bool beforeIn = false;       ///< the arc before the stretch is in, or the stretch begins at a source
    bool beforeAnchored = false; ///< all arcs before the stretch are in, from a source on
    bool afterIn = false;        ///< likewise after the stretch, towards the line's end
    bool afterAnchored = false;
};

/// The stretch from the first free arc to the last; none if no arc is free. It is divided in two where both
/// particles of the line can only meet at one place, because neither gets beyond that place.
[[nodiscard]] std::vector<LineStretch> stretchesOf(const ProblemInput& input, LineId line);

/// The values left to an arc by rule 1, by the arcs beyond the stretch, and by the demands.
/// \param position  of the arc on the line; inside the stretch
/// \throw Error  if no value is left
[[nodiscard]] ArcState domainOf(const ProblemInput& input, LineId line, const LineStretch& stretch,
                                int position);

/// Restricts a domain to a demand.
/// \param arc     the arc whose domain it is, for the error message
/// \param demand  `free` allows both values
/// \throw Error  if no value is left
void restrictDomain(const ArcGraph& graph, ArcId arc, ArcState& domain, ArcState demand);

} // namespace qm
