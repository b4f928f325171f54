/// \file Rule 4 (docs/METHOD.md#cracks): every crossing of two tracks needs a line that cracks it.
#pragma once

#include "enumerate/state/crack_forest.h"
#include "enumerate/state/line_rule.h"
#include "enumerate/state/values_with_undo.h"

#include <vector>

namespace qm {

/// Adds every crossing to the crack forest as soon as both its lines are known to be covered or to have a
/// gap.
class CrackRule {
public:
    /// \param assignment, lines  must outlive this
    CrackRule(const Problem& problem, const PartialAssignment& assignment, LineRule& lines);

    /// The crack node of a chain; none if its line cannot be cracked.
    [[nodiscard]] CrackNodeId nodeOfChain(ChainId chain) const { return nodeOfChain_[chain]; }
    [[nodiscard]] const std::vector<CrossingId>& crossingsOfNode(CrackNodeId node) const {
        return crossingsOfNode_[node];
    }
    /// The representative of the group of lines that crossings have joined to this node so far.
    [[nodiscard]] CrackNodeId group(CrackNodeId node) const { return forest_.find(node); }
    /// The number of head-on meetings that a group of lines has left.
    [[nodiscard]] int left(CrackNodeId group) const { return forest_.left(group); }

    /// All four arcs around a crossing are in.
    [[nodiscard]] bool isCrossed(CrossingId crossing) const;
    /// The crossing is crossed, but for one of its lines it is still open whether it is covered from end to
    /// end.
    [[nodiscard]] bool isPending(CrossingId crossing) const {
        return !counted_[crossing] && isCrossed(crossing);
    }
    /// No arc around a crossing is out.
    [[nodiscard]] bool mayBeCrossed(CrossingId crossing) const;

    /// Draws the conclusions of rule 4 at a crossing.
    /// \return false on a contradiction
    bool visitCrossing(CrossingId crossing);
    /// Draws the conclusions of rule 4 along a chain that is covered or has got a gap. Once is enough: what
    /// changes later is a crossing's arc, which is visited then, or whether the other line is covered.
    bool visitCovered(ChainId chain);

    struct Mark {
        std::size_t counted = 0;
        std::size_t visited = 0;
        std::size_t changes = 0;
    };
    [[nodiscard]] Mark mark() const {
        return {counted_.given().size(), visited_.given().size(), forest_.changes()};
    }
    void undo(const Mark& mark);

private:
    [[nodiscard]] Cover coverOf(CrackNodeId node) const;

    const Problem& problem_;
    const PartialAssignment& assignment_;
    LineRule& lines_;
    IdVector<ChainId, CrackNodeId> nodeOfChain_;
    IdVector<CrackNodeId, std::vector<CrossingId>> crossingsOfNode_;
    ValuesWithUndo<CrossingId, bool> counted_;  ///< crossings that are in the forest
    ValuesWithUndo<CrackNodeId, bool> visited_; ///< nodes whose crossings `visitCovered` has visited
    CrackForest forest_;
};

} // namespace qm
