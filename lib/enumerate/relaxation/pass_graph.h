/// \file Which particle passes which crossing and where it arrives next: the graph in which cuts of the
/// relaxation are found.
#pragma once

#include "enumerate/relaxation/formulation.h"

#include <array>

namespace qm {

/// Covers the plain crossings of a formulation, where particles may pass and stop on both lines. The two
/// sides of a crossing have successive ids.
class PassGraph {
public:
    using SideId = Id<struct PassSideTag>;
    static constexpr std::size_t directions = 2; ///< 0: the particle from before, 1: the particle from after

    /// One line at a crossing; all arrays are by direction, and their entries may be none.
    struct Side {
        std::array<ColumnId, directions> arrives; ///< 1 if the particle walks the arc to the crossing
        std::array<ColumnId, directions> passes;  ///< 1 if it also walks the arc that leads on
        std::array<SideId, directions> next;      ///< where it arrives next, if that crossing is plain
        VariableId before; ///< the variable before the crossing; orders the sides of a line
    };

    /// \param state  the one that the formulation was made from
    PassGraph(const SearchState& state, const Formulation& formulation);

    [[nodiscard]] const IdVector<SideId, Side>& sides() const { return sides_; }
    /// The other line at the same crossing.
    [[nodiscard]] static SideId across(SideId side) { return SideId(side.idx() ^ 1U); }

private:
    IdVector<SideId, Side> sides_;
};

} // namespace qm
