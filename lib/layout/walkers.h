/// \file Which particles take part.
#pragma once

#include "basecomplex/arc_graph.h"

#include <vector>

namespace qm {

/// Which particles take part: of every line the one from its begin and the one from its end. Empty means all.
struct Walkers {
    std::vector<bool> fromBegin;
    std::vector<bool> fromEnd;
    /// The last arc that the particle from the begin can walk, of every line whose two particles leave the
    /// sub-mesh over the same vertex outside and can only meet there; else invalid. May be empty.
    std::vector<ArcId> meetings;

    [[nodiscard]] ArcId meeting(LineId line) const {
        return meetings.empty() ? ArcId{} : meetings[line.idx()];
    }
    [[nodiscard]] bool begin(LineId line) const { return fromBegin.empty() || fromBegin[line.idx()]; }
    [[nodiscard]] bool end(LineId line) const { return fromEnd.empty() || fromEnd[line.idx()]; }
};

} // namespace qm
