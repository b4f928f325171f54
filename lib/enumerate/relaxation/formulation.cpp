#include "enumerate/relaxation/formulation.h"

#include "base/infinity.h"
#include "base/sort_unique.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <set>
#include <utility>

namespace qm {
namespace {

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

/// Makes the columns and the rows between columns of one chain, then the rows of crossings.
class Formulator {
public:
    /// \param variables  ascending; must outlive this, as the state must
    Formulator(const SearchState& state, const std::vector<VariableId>& variables)
        : state_(state), problem_(state.problem()), ours_(variables) {}

    Formulation make() {
        findCrossings();
        if (problem_.gaps) {
            knowChains();
            for (const ChainId chain : known_)
                addChain(problem_.chains[chain]);
        } else {
            for (const VariableId variable : ours_)
                result_.columnsOf.at(variable).fromBefore = newColumn(variable);
        }
        for (const CrossingId id : crossings_)
            if (const Crossing& crossing = problem_.crossings[id]; !anyForeign(crossing.arcs())) {
                addCrossing(crossing);
                if (isPlain(crossing)) result_.plainCrossings.push_back(id);
            }
        return std::move(result_);
    }

private:
    [[nodiscard]] bool isOut(VariableId variable) const { return state_.value(variable) == ArcState::out; }
    [[nodiscard]] bool isIn(VariableId variable) const { return state_.value(variable) == ArcState::in; }

    /// Whether free variables of another part are among these; then none of their rules concerns this part.
    template <class Variables> [[nodiscard]] bool anyForeign(const Variables& variables) const {
        return std::ranges::any_of(variables, [this](VariableId variable) {
            return state_.isFree(variable) && !std::ranges::binary_search(ours_, variable);
        });
    }

    void findCrossings() {
        for (const VariableId variable : ours_)
            std::ranges::copy(state_.crossingsOf(variable), std::back_inserter(crossings_));
        sortUnique(crossings_);
    }

    /// Finds the chains that get columns: those of the variables, and those of lines that are covered already
    /// but may still be cracked somewhere; and adds all crossings of these chains.
    void knowChains() {
        for (const VariableId variable : ours_)
            knowChain(state_.chainOf(variable));
        while (!fresh_.empty()) {
            const Chain& chain = problem_.chains[fresh_.back()];
            fresh_.pop_back();
            for (const VariableId v : chain.variables())
                for (const CrossingId id : state_.crossingsOf(v)) {
                    crossings_.push_back(id);
                    const std::array arcs = problem_.crossings[id].arcs();
                    if (std::ranges::any_of(arcs, [this](VariableId arc) { return isOut(arc); })) continue;
                    for (const VariableId arc : arcs)
                        knowChain(state_.chainOf(arc));
                }
        }
        sortUnique(crossings_);
    }

    void knowChain(ChainId chain) {
        if (!chain.valid() || known_.contains(chain) || anyForeign(problem_.chains[chain].variables()))
            return;
        known_.insert(chain);
        fresh_.push_back(chain);
    }

    /// \param variable  none for a flag
    ColumnId newColumn(VariableId variable = {}) {
        result_.costs.push_back(variable.valid() && state_.isFree(variable) ? problem_.costs[variable] : 0);
        result_.variableOf.push_back(variable);
        return result_.costs.nextId() - 1;
    }

    /// A variable that is out divides a chain: before it only the particle from before can walk, behind it
    /// only the other.
    void addChain(const Chain& chain) {
        VariableId firstOut = chain.first + chain.count, lastOut = chain.first - 1;
        for (const VariableId v : chain.variables())
            if (isOut(v)) {
                firstOut = std::min(firstOut, v);
                lastOut = v;
            }
        for (const VariableId v : chain.variables()) {
            if (isOut(v)) continue;
            Formulation::Columns& here = result_.columnsOf.at(v);
            if (chain.coveredBefore && v < firstOut) here.fromBefore = newColumn(v);
            if (chain.coveredAfter && v > lastOut) here.fromAfter = newColumn(v);
            if (here.fromBefore.valid() && here.fromAfter.valid()) {
                here.cover = result_.rows.nextId();
                result_.rows.push_back(
                    {{here.fromBefore, here.fromAfter}, {1, 1}, isIn(v) ? 1.0 : -infinity, 1});
            }
            if (v == chain.first) continue;
            const Formulation::Columns previous = columns(v - 1);
            if (previous.fromBefore.valid() && here.fromBefore.valid())
                addLowerLimit(Expression{}.add(previous.fromBefore, 1).add(here.fromBefore, -1), 0);
            if (previous.fromAfter.valid() && here.fromAfter.valid())
                addLowerLimit(Expression{}.add(here.fromAfter, 1).add(previous.fromAfter, -1), 0);
        }
    }

    /// Adds the row expression >= bound, unless it always holds.
    void addLowerLimit(const Expression& expression, double bound) {
        Formulation::Row row{{}, {}, bound - expression.constant, infinity};
        double min = 0;
        for (const auto& [column, weight] : expression.terms) {
            if (weight == 0) continue;
            row.columns.push_back(column);
            row.weights.push_back(weight);
            min += std::min(weight, 0.0);
        }
        if (min < row.lower) result_.rows.push_back(std::move(row));
    }

    [[nodiscard]] Formulation::Columns columns(VariableId variable) const {
        return result_.columnsOf[variable];
    }

    /// The presence y of a variable or constant.
    [[nodiscard]] Expression present(VariableId variable) const {
        const Formulation::Columns both = columns(variable);
        Expression expression = Expression{}.add(both.fromBefore, 1).add(both.fromAfter, 1);
        if (!both.any()) expression.constant = isIn(variable) ? 1 : 0;
        return expression;
    }

    /// Both arcs are in and the line cannot be cracked here, so it is passed in any case.
    [[nodiscard]] bool isWall(const CrossingSide& side) const {
        return !side.node.valid() && isIn(side.before) && isIn(side.after);
    }

    /// The arcs before and after the crossing are successive variables of one chain, and both have columns.
    [[nodiscard]] bool consecutive(const CrossingSide& side) const {
        return !isWall(side) && side.after == side.before + 1 && !problem_.isConstant(side.after) &&
               state_.chainOf(side.before) == state_.chainOf(side.after) && columns(side.before).any() &&
               columns(side.after).any();
    }

    /// Both sides are consecutive, and all rules hold.
    [[nodiscard]] bool isPlain(const Crossing& crossing) const {
        return problem_.gaps && !crossing.open && consecutive(crossing.sides[0]) &&
               consecutive(crossing.sides[1]);
    }

    /// 1 if a particle passes: it walks the arc behind the crossing, seen from where it comes from.
    [[nodiscard]] Expression pass(const CrossingSide& side) const {
        return Expression{}.add(columns(side.after).fromBefore, 1).add(columns(side.before).fromAfter, 1);
    }

    /// An expression that is at most 1 if a single particle passes, and 0 if none does.
    [[nodiscard]] Expression surePass(const CrossingSide& side) const {
        if (isOut(side.before) || isOut(side.after)) return {};
        if (isWall(side)) return {.terms = {}, .constant = 1};
        if (consecutive(side)) return pass(side);
        Expression expression;
        if (side.before == problem_.in()) expression.add(columns(side.after).fromBefore, 1);
        if (side.after == problem_.in()) expression.add(columns(side.before).fromAfter, 1);
        return expression;
    }

    /// Whether the particle from before stops here, and whether the particle from after does.
    [[nodiscard]] std::array<Expression, 2> particleStops(const CrossingSide& side) const {
        const Formulation::Columns before = columns(side.before), after = columns(side.after);
        return {Expression{}.add(before.fromBefore, 1).add(after.fromBefore, -1),
                Expression{}.add(after.fromAfter, 1).add(before.fromAfter, -1)};
    }

    /// Adds the rows of rules 2 and 4, and the cost of corners.
    void addCrossing(const Crossing& crossing) {
        if (!crossing.open)
            for (const std::size_t k : {0U, 1U})
                addStops(crossing.sides[k], crossing.sides[1 - k]);
        if (crossing.cornerCost != 0 &&
            std::ranges::any_of(crossing.arcs(), [this](VariableId arc) { return state_.isFree(arc); }))
            addCorners(crossing);
        if (!problem_.gaps) return;
        Expression passes;
        for (const CrossingSide& side : crossing.sides)
            passes.add(surePass(side), -1);
        addLowerLimit(passes, -1);
    }

    /// Rule 2: if a track ends on `side`, the line `wall` is passed or both its arcs are present.
    void addStops(const CrossingSide& side, const CrossingSide& wall) {
        std::array<Expression, 2> stops{present(side.before).add(present(side.after), -1),
                                        present(side.after).add(present(side.before), -1)};
        if (problem_.gaps && consecutive(side)) stops = particleStops(side);
        std::vector<Expression> walls{present(wall.before), present(wall.after)};
        if (problem_.gaps && consecutive(wall)) walls = {pass(wall)};
        for (const Expression& stop : stops)
            for (Expression row : walls)
                addLowerLimit(row.add(stop, -1), 0);
    }

    /// Adds the cost of corners at a crossing, except those between arcs that are in already.
    void addCorners(const Crossing& crossing) {
        Expression corners = problem_.gaps ? cornersByStops(crossing) : cornersByArcs(crossing);
        corners.constant -= crossing.corners([this](VariableId arc) { return isIn(arc); });
        for (const auto& [column, weight] : corners.terms)
            result_.costs[column] += crossing.cornerCost * weight;
        result_.constant += crossing.cornerCost * corners.constant;
    }

    /// The number of corners: two for every particle that stops.
    [[nodiscard]] Expression cornersByStops(const Crossing& crossing) const {
        Expression corners;
        for (const CrossingSide& side : crossing.sides) {
            if (isWall(side)) continue;
            if (consecutive(side)) {
                for (const Expression& stop : particleStops(side))
                    corners.add(stop, 2);
                continue;
            }
            VariableId known = side.before, other = side.after; // one of the two is fixed
            if (columns(known).any()) std::swap(known, other);
            const int sign = isIn(known) ? 1 : -1;
            corners.add(present(known), 2 * sign).add(present(other), -2 * sign);
        }
        return corners;
    }

    /// The number of corners: two for every arc, less four if there is any arc. A new column, a flag, is 1 if
    /// there is none.
    Expression cornersByArcs(const Crossing& crossing) {
        const ColumnId empty = newColumn();
        Expression corners{{{empty, 4}}, -4};
        for (const VariableId arc : crossing.arcs()) {
            corners.add(present(arc), 2);
            addLowerLimit(Expression{}.add(empty, -1).add(present(arc), -1), -1);
        }
        const auto& [a, b] = crossing.sides;
        for (const VariableId one : {a.before, a.after})
            for (const VariableId other : {b.before, b.after})
                addLowerLimit(Expression{}.add(empty, 1).add(present(one), 1).add(present(other), 1), 1);
        return corners;
    }

    const SearchState& state_;
    const Problem& problem_;
    const std::vector<VariableId>& ours_; ///< variables of the part
    Formulation result_;
    std::vector<CrossingId> crossings_; ///< those that need rows
    std::set<ChainId> known_;           ///< chains that get columns
    std::vector<ChainId> fresh_;        ///< chains in `known_` whose crossings have not been visited
};

} // namespace

Formulation formulate(const SearchState& state, const std::vector<VariableId>& variables) {
    return Formulator(state, variables).make();
}

} // namespace qm
