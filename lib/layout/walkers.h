/// \file Which particles take part.
#pragma once

#include "basecomplex/arc_graph.h"

#include <vector>

namespace qm {

/// Which particles may walk, of every line those of its begin and of its end; where empty, all.
struct Walkers {
    std::vector<bool> fromBegin;
    std::vector<bool> fromEnd;
    /// Of every line the arc after which its particles meet if they do, where that is settled: they leave the
    /// sub-mesh over one vertex outside. May be empty.
    std::vector<ArcId> meetings;

    [[nodiscard]] ArcId meeting(LineId line) const {
        return meetings.empty() ? ArcId{} : meetings[line.idx()];
    }
    [[nodiscard]] bool begin(LineId line) const { return fromBegin.empty() || fromBegin[line.idx()]; }
    [[nodiscard]] bool end(LineId line) const { return fromEnd.empty() || fromEnd[line.idx()]; }
};

} // namespace qm
