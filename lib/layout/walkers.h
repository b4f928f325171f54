/// \file The particles that take part in a search.
#pragma once

#include "base/ids.h"

#include <optional>
#include <unordered_map>

namespace qm {

/// Which particles of a line take part.
struct LineWalkers {
    bool fromBegin = false;
    bool fromEnd = false;
    /// If both particles of a line leave the sub-mesh over the same vertex outside, they can only meet there;
    /// then this is the last arc that the particle from the line's beginning can walk. None for other lines.
    ArcId meeting = {};
};

/// Which particles of every line take part, in memory that is linear in the number of lines with such
/// particles.
class Walkers {
public:
    /// All particles take part.
    Walkers() = default;
    /// Only particles of the given lines take part.
    explicit Walkers(std::unordered_map<LineId, LineWalkers> ofLine) : ofLine_(std::move(ofLine)) {}

    [[nodiscard]] ArcId meeting(LineId line) const { return of(line).meeting; }
    [[nodiscard]] bool fromBegin(LineId line) const { return of(line).fromBegin; }
    [[nodiscard]] bool fromEnd(LineId line) const { return of(line).fromEnd; }

private:
    [[nodiscard]] LineWalkers of(LineId line) const {
        if (!ofLine_) return {true, true, {}};
        const auto found = ofLine_->find(line);
        return found == ofLine_->end() ? LineWalkers{} : found->second;
    }

    std::optional<std::unordered_map<LineId, LineWalkers>> ofLine_;
};

} // namespace qm
