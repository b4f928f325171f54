/// \file Rule 3 (docs/METHOD.md#arc-rules): where a line may be out, and which lines are covered from end to
/// end.
#pragma once

#include "enumerate/state/partial_assignment.h"

#include <vector>

namespace qm {

/// What is known of a line with two sources: covered from end to end, or with a gap.
enum class Cover { open, full, gapped };

/// Knows the gap of every chain, and draws the conclusions inside and outside of it.
class LineRule {
public:
    /// \param assignment  outlives this
    LineRule(const Problem& problem, PartialAssignment& assignment)
        : problem_(problem), assignment_(assignment), hulls_(problem.chains.size()),
          promised_(problem.chains.size(), false) {}

    [[nodiscard]] Cover coverOf(ChainId chain) const {
        if (hasGap(chain) || promised_[chain]) return Cover::gapped;
        return isFull(chain) ? Cover::full : Cover::open;
    }
    /// True once a variable of the chain is out.
    [[nodiscard]] bool hasGap(ChainId chain) const { return !hulls_[chain].empty(); }
    /// All variables of the chain are in.
    [[nodiscard]] bool isFull(ChainId chain) const {
        return assignment_.inCount(chain) == problem_.chains[chain].count;
    }

    /// Draws the conclusions from a variable of a chain that has just been assigned.
    /// \return false on a contradiction
    bool visit(VariableId variable);

    /// Sets all variables of a chain.
    /// \return false on a contradiction
    bool cover(ChainId chain);

    /// Promises that a chain, which is not covered, will have a gap.
    void promiseGap(ChainId chain);

    struct Mark {
        std::size_t hulls = 0;
        std::size_t promises = 0;
    };
    [[nodiscard]] Mark mark() const { return {hullTrail_.size(), promiseTrail_.size()}; }
    void undo(const Mark& mark);

private:
    struct Hull { ///< of the variables of a chain that are out
        VariableId first;
        VariableId last;
        [[nodiscard]] bool empty() const { return !first.valid(); }
    };
    struct HullChange {
        ChainId chain;
        Hull before;
    };

    bool closeOneSided(const Chain& chain, VariableId variable, ArcState value);
    bool openGap(ChainId chain, VariableId variable);

    const Problem& problem_;
    PartialAssignment& assignment_;
    IdVector<ChainId, Hull> hulls_;
    IdVector<ChainId, bool> promised_; ///< chains that are to have a gap
    std::vector<HullChange> hullTrail_;
    std::vector<ChainId> promiseTrail_;
};

} // namespace qm
