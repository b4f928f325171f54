/// \file A partial assignment together with the values of a formulation's columns, with undo.
#pragma once

#include "enumerate/relaxation/formulation.h"
#include "enumerate/state/search_state.h"
#include "enumerate/state/values_with_undo.h"

#include <vector>

namespace qm {

/// One branching decision about a variable: whether it is in, or whether the particle from before (from
/// after) walks it.
struct Decision {
    enum class About : signed char { value, fromBefore, fromAfter };
    VariableId variable;
    About about = About::value;
    ArcState state = ArcState::free;
};

/// Values of a formulation's columns, kept consistent with every row and with the values of the variables.
class ColumnState {
public:
    /// \param state        must outlive this, and must be changed through this only
    /// \param formulation  rows that are added to it later are ignored
    ColumnState(SearchState& state, const Formulation& formulation);

    /// False if the rules contradict each other already.
    [[nodiscard]] bool consistent() const { return consistent_; }

    [[nodiscard]] const SearchState& arcs() const { return arcs_; }
    /// In, out or free.
    [[nodiscard]] ArcState value(ColumnId column) const { return columns_[column]; }
    /// The lower limit of a row; it is above the formulation's if the row's variable must be covered.
    [[nodiscard]] double rowLower(RowId row) const;

    struct Mark {
        SearchState::Mark arcs;
        std::size_t columns = 0;
        std::size_t demands = 0;
    };
    [[nodiscard]] Mark mark() const;
    void undo(const Mark& mark);

    /// Takes a decision, or confirms it, and draws all conclusions.
    /// \return false on a contradiction; the caller must then undo
    bool take(const Decision& decision);
    bool fixColumn(ColumnId column, ArcState value);

private:
    bool set(ColumnId column, ArcState value);
    bool settle();
    bool rowsToColumns();
    bool arcsToColumns();
    bool passOn(VariableId variable);
    bool columnsToArcs();
    bool visitRow(RowId row);

    SearchState& arcs_;
    const Formulation& formulation_;
    ValuesWithUndo<ColumnId, ArcState> columns_;
    ValuesWithUndo<RowId, bool> demanded_; ///< rows p + s <= 1 of variables that are in
    const IdVector<ColumnId, std::vector<RowId>> rowsOf_;
    // Up to where what is given has been followed: the consequences of everything before have been drawn.
    SearchState::Mark seen_;      ///< assigned variables, passed on to their columns
    std::size_t propagated_ = 0;  ///< columns, passed on to the rows that contain them
    std::size_t told_ = 0;        ///< columns, passed on to their variables
    std::size_t demandsSeen_ = 0; ///< demanded rows, passed on to their columns
    bool consistent_ = true;
};

} // namespace qm
