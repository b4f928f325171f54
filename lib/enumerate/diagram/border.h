/// \file The part of a search state that still matters: states that agree in it can be completed in the same
/// ways.
#pragma once

#include "enumerate/diagram/elimination_order.h"
#include "enumerate/state/search_state.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace qm {

/// Describes the border between what the first steps have decided and the rest: the values of variables at
/// crossings and on chains that lie on both sides of it, which of these chains have a gap, and how many
/// head-on meetings their lines have left. All other values follow from these by propagation.
class DiagramBorder {
public:
    DiagramBorder(const SearchState& state, const std::vector<Step>& steps);

    /// The length in words of a description before a step; it is the same for every state.
    [[nodiscard]] std::size_t words(std::size_t step) const { return watches_[step].words; }

    /// Writes the description of a state in which all steps before this one are decided to `words(step)`
    /// words.
    void describe(const SearchState& state, std::size_t step, std::uint64_t* words);

private:
    struct Watch {
        std::vector<VariableId> variables;
        std::vector<ChainId> chains;
        std::vector<CrackNodeId> nodes;
        std::size_t words = 0;
    };

    /// Whether the node's lines are covered and may still crack a crossing that a later step decides. If they
    /// have no meeting left, only crossings count that wait to learn whether their other line can crack them.
    [[nodiscard]] bool canCrack(const SearchState& state, std::size_t step, CrackNodeId node) const;
    [[nodiscard]] std::uint64_t coverCode(const SearchState& state, std::size_t step, ChainId chain) const;

    std::vector<Watch> watches_;
    IdVector<CrossingId, int> lastStep_;           ///< the last step that decides something at a crossing
    IdVector<CrackNodeId, std::uint16_t> labelOf_; ///< label of every group, used during `describe`
};

} // namespace qm
