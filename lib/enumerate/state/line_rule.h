/// \file Rule 3 (docs/METHOD.md#arc-rules): where the gap of a line may lie, and which lines are covered from
/// end to end.
#pragma once

#include "enumerate/state/partial_assignment.h"
#include "enumerate/state/values_with_undo.h"

#include <vector>

namespace qm {

/// What is known about a line with two sources: nothing yet, covered from end to end, or with a gap.
enum class Cover { open, full, gapped };

/// Keeps the gap of every chain, and draws the conclusions of rule 3 inside and outside of it.
class LineRule {
public:
    /// \param assignment  must outlive this
    LineRule(const Problem& problem, PartialAssignment& assignment)
        : problem_(problem), assignment_(assignment), gaps_(problem.chains.size()),
          promised_(problem.chains.size(), false) {}

    [[nodiscard]] Cover coverOf(ChainId chain) const {
        if (hasGap(chain) || promised_[chain]) return Cover::gapped;
        return isFull(chain) ? Cover::full : Cover::open;
    }
    /// True once a variable of the chain is out; always false for a chain not covered from both sides.
    [[nodiscard]] bool hasGap(ChainId chain) const { return !gaps_[chain].empty(); }
    /// All variables of the chain are in.
    [[nodiscard]] bool isFull(ChainId chain) const {
        return assignment_.inCount(chain) == problem_.chains[chain].count;
    }

    /// Draws the conclusions of rule 3 from a variable of a chain that has just been assigned.
    /// \return false on a contradiction
    bool visit(VariableId variable);

    /// Sets all variables of a chain to in.
    /// \return false on a contradiction
    bool cover(ChainId chain);

    /// Promises that a chain that is not covered will have a gap.
    void promiseGap(ChainId chain) { promised_.give(chain, true); }

    struct Mark {
        std::size_t gaps = 0;
        std::size_t promises = 0;
    };
    [[nodiscard]] Mark mark() const { return {gapTrail_.size(), promised_.given().size()}; }
    void undo(const Mark& mark);

private:
    struct Gap { ///< from the first to the last variable of a chain that is out
        VariableId first;
        VariableId last;
        [[nodiscard]] bool empty() const { return !first.valid(); }
    };
    struct GapChange {
        ChainId chain;
        Gap before;
    };

    bool spread(const Chain& chain, VariableId variable, int step);
    bool openGap(ChainId chain, VariableId variable);

    const Problem& problem_;
    PartialAssignment& assignment_;
    IdVector<ChainId, Gap> gaps_;
    std::vector<GapChange> gapTrail_;
    ValuesWithUndo<ChainId, bool> promised_; ///< whether a chain must have a gap
};

} // namespace qm
