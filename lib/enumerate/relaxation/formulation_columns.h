/// \file The columns of a formulation, and expressions over them: who walks an arc, passes a junction, or
/// stops there.
#pragma once

#include "enumerate/relaxation/formulation.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>
#include <vector>

namespace qm {

/// A linear expression over columns and a constant.
struct Expression {
    std::vector<std::pair<ColumnId, double>> terms;
    double constant = 0;

    /// \param column  none counts as 0
    Expression& add(ColumnId column, double weight) {
        if (!column.valid()) return *this;
        const auto known = std::ranges::find(terms, column, [](const auto& term) { return term.first; });
        if (known == terms.end())
            terms.emplace_back(column, weight);
        else
            known->second += weight;
        return *this;
    }
    Expression& add(const Expression& other, double factor) {
        for (const auto& [column, weight] : other.terms)
            add(column, factor * weight);
        constant += factor * other.constant;
        return *this;
    }
};

/// Makes the columns, and the rows between columns of one chain.
class FormulationColumns {
public:
    /// \param variables  ascending; must outlive this, as the state must
    FormulationColumns(const SearchState& state, const std::vector<VariableId>& variables);

    /// The crossings that need rows: those of the variables, and those of lines that are covered but may be
    /// cracked.
    [[nodiscard]] const std::vector<CrossingId>& crossings() const { return crossings_; }
    [[nodiscard]] Formulation take() { return std::move(result_); }

    [[nodiscard]] bool isOut(VariableId variable) const { return state_.value(variable) == ArcState::out; }
    [[nodiscard]] bool isIn(VariableId variable) const { return state_.value(variable) == ArcState::in; }
    /// Whether a crossing has free arcs of another part; then none of its rules concerns this part.
    [[nodiscard]] bool isForeign(const Crossing& crossing) const;

    [[nodiscard]] Formulation::Columns columns(VariableId variable) const {
        return result_.columnsOf[variable];
    }
    /// The presence y of a variable or constant.
    [[nodiscard]] Expression present(VariableId variable) const;
    /// Both arcs are in and the line cannot be cracked here, so it is passed in any case.
    [[nodiscard]] bool isWall(const CrossingSide& side) const;
    /// The arcs before and after the crossing are successive variables of one chain, and both have columns.
    [[nodiscard]] bool consecutive(const CrossingSide& side) const;
    /// Both sides are consecutive, all rules hold, and no free arc belongs to another part.
    [[nodiscard]] bool isPlain(const Crossing& crossing) const;
    /// 1 if a particle passes: it walks the arc behind the crossing, seen from where it comes from.
    [[nodiscard]] Expression pass(const CrossingSide& side) const;
    /// An expression that is at most 1 if a single particle passes, and 0 if none does.
    [[nodiscard]] Expression surePass(const CrossingSide& side) const;
    /// Whether the particle from before stops here, and whether the particle from after does.
    [[nodiscard]] std::array<Expression, 2> particleStops(const CrossingSide& side) const;

    /// Adds the row expression >= bound, unless it always holds.
    void addLowerLimit(const Expression& expression, double bound);
    void addCost(const Expression& expression, double factor);
    /// A new column that belongs to no variable.
    ColumnId newFlag();

private:
    [[nodiscard]] bool isForeign(VariableId variable) const;
    [[nodiscard]] bool isForeign(const Chain& chain) const;
    void knowChain(ChainId chain);
    void knowCovered();
    ColumnId newColumn(VariableId variable);
    void addChain(const Chain& chain);

    const SearchState& state_;
    const Problem& problem_;
    Formulation result_;
    std::vector<CrossingId> crossings_;
    const std::vector<VariableId>& ours_; ///< variables of the part
    std::set<ChainId> known_;             ///< chains that get columns
    std::vector<ChainId> fresh_;          ///< chains in `known_` whose crossings have not been visited
};

} // namespace qm
