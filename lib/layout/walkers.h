/// \file Which particles take part.
#pragma once

#include "base/ids.h"

#include <optional>
#include <unordered_map>

namespace qm {

/// Which particles of a line take part.
struct LineWalkers {
    bool fromBegin = false;
    bool fromEnd = false;
    /// Of a line whose two particles leave the sub-mesh over the same vertex outside, and can only meet
    /// there: the last arc that the particle from its beginning can walk. None of other lines.
    ArcId meeting = {};
};

/// Of every line, in memory that depends on those only whose particles take part.
class Walkers {
public:
    /// All particles.
    Walkers() = default;
    /// Those of the given lines, and no others.
    explicit Walkers(std::unordered_map<LineId, LineWalkers> ofLine) : ofLine_(std::move(ofLine)) {}

    [[nodiscard]] ArcId meeting(LineId line) const { return of(line).meeting; }
    [[nodiscard]] bool begin(LineId line) const { return of(line).fromBegin; }
    [[nodiscard]] bool end(LineId line) const { return of(line).fromEnd; }

private:
    [[nodiscard]] LineWalkers of(LineId line) const {
        if (!ofLine_) return {true, true, {}};
        const auto found = ofLine_->find(line);
        return found == ofLine_->end() ? LineWalkers{} : found->second;
    }

    std::optional<std::unordered_map<LineId, LineWalkers>> ofLine_;
};

} // namespace qm
