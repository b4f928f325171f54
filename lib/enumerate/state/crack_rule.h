/// \file Rule 4 (docs/METHOD.md#cracks): which lines crack which crossings.
#pragma once

#include "enumerate/state/crack_forest.h"
#include "enumerate/state/line_rule.h"

#include <vector>

namespace qm {

/// Tells the crack forest of every crossing as soon as its lines are known to be covered or gapped.
class CrackRule {
public:
    /// \param assignment, lines  outlive this
    CrackRule(const Problem& problem, const PartialAssignment& assignment, LineRule& lines);

    /// The crack node of a chain; none if its line cannot be cracked.
    [[nodiscard]] CrackNodeId nodeOfChain(ChainId chain) const { return nodeOfChain_[chain]; }
    [[nodiscard]] const std::vector<CrossingId>& crossingsOfNode(CrackNodeId node) const {
        return crossingsOfNode_[node];
    }
    /// A representative of the lines that crossings have joined with this one so far.
    [[nodiscard]] CrackNodeId group(CrackNodeId node) const { return forest_.find(node); }
    /// Head-on meetings that a group of lines has left.
    [[nodiscard]] int left(CrackNodeId group) const { return forest_.left(group); }

    /// All four arcs around a crossing are in.
    [[nodiscard]] bool isCrossed(CrossingId crossing) const;
    /// It is crossed, and not known yet which of its lines are covered from end to end.
    [[nodiscard]] bool isPending(CrossingId crossing) const {
        return !counted_[crossing] && isCrossed(crossing);
    }
    /// No arc around a crossing is out.
    [[nodiscard]] bool mayBeCrossed(CrossingId crossing) const;

    /// Draws the conclusions from what is known around a crossing.
    /// \return false on a contradiction
    bool visitCrossing(CrossingId crossing);
    /// Draws the conclusions from a chain that has just been covered or got a gap.
    bool visitCovered(ChainId chain);

    struct Mark {
        std::size_t counted = 0;
        std::size_t changes = 0;
    };
    [[nodiscard]] Mark mark() const { return {countedTrail_.size(), forest_.changes()}; }
    void undo(const Mark& mark);

private:
    [[nodiscard]] Cover coverOf(CrackNodeId node) const;

    const Problem& problem_;
    const PartialAssignment& assignment_;
    LineRule& lines_;
    IdVector<ChainId, CrackNodeId> nodeOfChain_;
    IdVector<CrackNodeId, std::vector<CrossingId>> crossingsOfNode_;
    IdVector<CrossingId, bool> counted_; ///< crossings that the forest knows
    std::vector<CrossingId> countedTrail_;
    CrackForest forest_;
};

} // namespace qm
