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

    [[nodiscard]] Cover coverOf(int chain) const {
        if (hasGap(chain) || promised_[static_cast<std::size_t>(chain)]) return Cover::gapped;
        return isFull(chain) ? Cover::full : Cover::open;
    }
    /// True once a variable of the chain is out.
    [[nodiscard]] bool hasGap(int chain) const {
        const Hull& hull = hulls_[static_cast<std::size_t>(chain)];
        return hull.first <= hull.last;
    }
    /// All variables of the chain are in.
    [[nodiscard]] bool isFull(int chain) const {
        return assignment_.inCount(chain) == problem_.chains[static_cast<std::size_t>(chain)].count;
    }

    /// Draws the conclusions from a variable of a chain that has just been assigned.
    /// \return false on a contradiction
    bool visit(int variable);

    /// Sets all variables of a chain.
    /// \return false on a contradiction
    bool cover(int chain);

    /// Promises that a chain, which is not covered, will have a gap.
    void promiseGap(int chain);

    struct Mark {
        std::size_t hulls = 0;
        std::size_t promises = 0;
    };
    [[nodiscard]] Mark mark() const { return {hullTrail_.size(), promiseTrail_.size()}; }
    void undo(const Mark& mark);

private:
    struct Hull { ///< of a chain's zeros; empty when first > last
        int first = 0;
        int last = -1;
    };
    struct HullChange {
        int chain;
        Hull before;
    };

    bool closeOneSided(const Chain& chain, int variable, ArcState value);
    bool openGap(int chain, int variable);

    const Problem& problem_;
    PartialAssignment& assignment_;
    std::vector<Hull> hulls_;    ///< of every chain
    std::vector<bool> promised_; ///< chains that are to have a gap
    std::vector<HullChange> hullTrail_;
    std::vector<int> promiseTrail_;
};

} // namespace qm
