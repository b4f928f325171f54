/// \file The columns of a formulation and what can be said with them: who walks an arc, passes a junction, or
/// stops there.
#pragma once

#include "enumerate/optimum/formulation.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace qm {

/// A linear expression over columns and a constant.
struct Expression {
    std::vector<std::pair<ColumnId, double>> terms;
    double constant = 0;

    Expression& add(ColumnId column, double weight) {
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

/// Sets up columns, and the rows that tie those of one chain.
class FormulationColumns {
public:
    FormulationColumns(const SearchState& state, const std::vector<VariableId>& variables);

    /// The crossings that have rows: those of the variables, and of lines that are covered but may be
    /// cracked.
    [[nodiscard]] const std::vector<CrossingId>& crossings() const { return crossings_; }
    [[nodiscard]] Formulation take() { return std::move(result_); }

    [[nodiscard]] bool isOut(VariableId variable) const { return state_.value(variable) == ArcState::out; }
    [[nodiscard]] bool isIn(VariableId variable) const { return state_.value(variable) == ArcState::in; }
    /// Some of its arcs are free but belong to another part, so that no rule here concerns this part.
    [[nodiscard]] bool isForeign(const Crossing& crossing) const;

    [[nodiscard]] const Formulation::Columns& columns(VariableId variable) const {
        return result_.columnsOf[variable];
    }
    /// y of a variable or constant.
    [[nodiscard]] Expression present(VariableId variable) const;
    /// Both arcs are in and the line cannot be cracked here: one particle passes, or two start here.
    [[nodiscard]] bool isWall(const CrossingSide& side) const;
    /// The arcs before and after are variables of one chain.
    [[nodiscard]] bool consecutive(const CrossingSide& side) const;
    /// That of all sides, where the rules hold and none of the arcs belongs to another part.
    [[nodiscard]] bool isPlain(const Crossing& crossing) const;
    /// One particle passes from one arc to the next if it is still running on the second.
    [[nodiscard]] Expression pass(const CrossingSide& side) const;
    /// At most 1 if a single particle passes, and 0 if none does.
    [[nodiscard]] Expression surePass(const CrossingSide& side) const;
    /// The particle from before stops here, and the particle from after.
    [[nodiscard]] std::array<Expression, 2> particleStops(const CrossingSide& side) const;

    /// A row: expression >= bound, unless that says nothing.
    void atLeast(const Expression& expression, double bound);
    void addCost(const Expression& expression, double factor);
    /// A column that stands for no particle.
    ColumnId newFlag();

private:
    [[nodiscard]] bool isForeign(VariableId variable) const;
    [[nodiscard]] bool isForeign(const Chain& chain) const;
    [[nodiscard]] bool anyOut(const Crossing& crossing) const;
    void knowChain(ChainId chain);
    void knowCovered();
    ColumnId newColumn(VariableId variable);
    void addChain(const Chain& chain);

    const SearchState& state_;
    const Problem& problem_;
    Formulation result_;
    std::vector<CrossingId> crossings_;
    IdVector<VariableId, bool> ours_; ///< those of the part
    IdVector<ChainId, bool> known_;   ///< those that get columns
    std::vector<ChainId> fresh_;      ///< of these, the ones whose crossings have not been looked at
};

} // namespace qm
