/// \file Which particle passes which crossing, and where it arrives next: what cuts of the relaxation are
/// found in.
#pragma once

#include "enumerate/optimum/formulation.h"

#include <array>

namespace qm {

/// Of all crossings where the rules hold as they stand for both lines: each may be passed and stopped at from
/// both sides. The two lines of a crossing stand one after the other.
class PassGraph {
public:
    using SideId = Id<struct PassSideTag>;
    static constexpr std::size_t directions = 2; ///< the particle from before, the particle from after

    /// One line at a crossing.
    struct Side {
        std::array<ColumnId, directions> arrives; ///< the particle walks the arc that leads here; maybe none
        std::array<ColumnId, directions> passes;  ///< it walks the next one as well; maybe none
        std::array<SideId, directions> next;      ///< where it arrives then; none if that is no such crossing
        VariableId before;                        ///< the arc before, which orders the sides of one line
    };

    /// \param state        that of the formulation
    PassGraph(const SearchState& state, const Formulation& formulation);

    [[nodiscard]] const IdVector<SideId, Side>& sides() const { return sides_; }
    /// The other line.
    [[nodiscard]] static SideId across(SideId side) { return SideId(side.idx() ^ 1U); }

private:
    IdVector<SideId, Side> sides_;
};

} // namespace qm
