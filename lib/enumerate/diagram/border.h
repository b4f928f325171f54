/// \file What of the decisions so far still matters: two states that agree in it can be completed in the same
/// ways.
#pragma once

#include "enumerate/diagram/elimination_order.h"
#include "enumerate/state/search_state.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace qm {

/// Describes the border between what the first steps have decided and the rest: the values around crossings
/// and on chains that lie on both sides of it, which of these chains have a gap, and how many head-on
/// meetings the lines on it have left. All other values follow from these by propagation.
class DiagramBorder {
public:
    DiagramBorder(const SearchState& state, const std::vector<Step>& steps);

    /// Words of a description before a step; the same for every state.
    [[nodiscard]] std::size_t words(std::size_t step) const { return watches_[step].words; }

    /// Writes the description of a state, which has decided the steps before this one, to `words(step)`
    /// words.
    void describe(const SearchState& state, std::size_t step, std::uint64_t* words);

private:
    struct Watch {
        std::vector<VariableId> variables;
        std::vector<ChainId> chains;
        std::vector<CrackNodeId> nodes;
        std::size_t words = 0;
    };

    /// The node's lines are covered, and that may still play a part: another crossing may need a head-on
    /// meeting on them while they have one left, or waits to learn whether its other line can be cracked.
    [[nodiscard]] bool canCrack(const SearchState& state, std::size_t step, CrackNodeId node) const;
    [[nodiscard]] std::uint64_t coverCode(const SearchState& state, std::size_t step, ChainId chain) const;

    std::vector<Watch> watches_;
    IdVector<CrossingId, int> lastStep_;           ///< when all around a crossing is decided
    IdVector<CrackNodeId, std::uint16_t> labelOf_; ///< of every group, while describing
};

} // namespace qm
