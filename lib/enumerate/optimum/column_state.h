/// \file A partial assignment together with the values of a formulation's columns, with undo.
#pragma once

#include "enumerate/optimum/formulation.h"
#include "enumerate/state/search_state.h"

#include <vector>

namespace qm {

/// What a branch of the search says of one variable: its value, or that the particle from before (after) does
/// or does not walk it.
struct Decision {
    enum class About : signed char { value, fromBefore, fromAfter };
    VariableId variable;
    About about = About::value;
    ArcState state = ArcState::free;
};

/// Values of the columns of a formulation, kept consistent row by row and with the values of the arcs.
class ColumnState {
public:
    /// \param state        outlives this, and is changed through it only
    /// \param formulation  rows that it gets later are not looked at
    ColumnState(SearchState& state, const Formulation& formulation);

    /// False if the rules contradict each other already.
    [[nodiscard]] bool consistent() const { return consistent_; }

    [[nodiscard]] const SearchState& arcs() const { return arcs_; }
    /// In, out or free.
    [[nodiscard]] ArcState value(ColumnId column) const { return columns_[column]; }
    /// The lower side of a row; above the formulation's where a variable must be covered.
    [[nodiscard]] double rowLower(RowId row) const;

    struct Mark {
        SearchState::Mark arcs;
        std::size_t columns = 0;
        std::size_t demands = 0;
    };
    [[nodiscard]] Mark mark() const;
    void undo(const Mark& mark);

    /// \return false on a contradiction; then undo
    bool take(const Decision& decision);
    bool fixColumn(ColumnId column, ArcState value);

private:
    bool set(ColumnId column, ArcState value);
    bool settle();
    bool arcsToColumns();
    bool columnsToArcs();
    bool visitRow(RowId row);

    SearchState& arcs_;
    const Formulation& formulation_;
    IdVector<ColumnId, ArcState> columns_;
    IdVector<RowId, bool> demanded_; ///< rows p + s <= 1 of variables that are in
    IdVector<ColumnId, std::vector<RowId>> rowsOf_;
    std::vector<ColumnId> columnTrail_;
    std::vector<RowId> demandTrail_;
    // How far each trail has been followed: what is before has had its consequences.
    SearchState::Mark seen_;      ///< of the arcs, in the columns
    std::size_t propagated_ = 0;  ///< of the columns, in the rows that hold them
    std::size_t told_ = 0;        ///< of the columns, in the arcs
    std::size_t demandsSeen_ = 0; ///< of the demanded rows, in their columns
    bool consistent_ = true;
};

} // namespace qm
