#include "enumerate/formulation.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

namespace qm {
namespace {

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A linear expression over columns and a constant.
struct Expression {
    std::vector<std::pair<int, double>> terms;
    double constant = 0;

    Expression& add(int column, double weight) {
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

class Builder {
public:
    explicit Builder(const SearchState& state) : state_(state), problem_(state.problem()) {
        result_.columnsOf.resize(problem_.domains.size());
        result_.coverRowOf.assign(problem_.domains.size(), -1);
        known_.assign(problem_.chains.size(), false);
        ours_.assign(problem_.domains.size(), false);
    }

    Formulation build(const std::vector<int>& variables) {
        for (const int variable : variables)
            ours_[at(variable)] = true;
        std::vector<int> crossings = crossingsOf(variables);
        if (problem_.gaps) {
            for (const int variable : variables)
                knowChain(state_.chainOf(variable));
            knowCovered(crossings);
            for (std::size_t chain = 0; chain < problem_.chains.size(); ++chain)
                if (known_[chain]) addChain(problem_.chains[chain]);
        } else {
            for (const int variable : variables)
                result_.columnsOf[at(variable)].fromBefore = newColumn(variable);
        }
        for (const int crossing : crossings)
            addCrossing(problem_.crossings[at(crossing)]);
        return std::move(result_);
    }

private:
    static void makeUnique(std::vector<int>& values) {
        std::ranges::sort(values);
        values.erase(std::unique(values.begin(), values.end()), values.end());
    }

    std::vector<int> crossingsOf(const std::vector<int>& variables) const {
        std::vector<int> result;
        for (const int variable : variables)
            result.insert(result.end(), state_.crossingsOf(variable).begin(),
                          state_.crossingsOf(variable).end());
        makeUnique(result);
        return result;
    }

    /// Free, but of another part, which no rule ties to this one.
    bool isForeign(int variable) const { return state_.isFree(variable) && !ours_[at(variable)]; }
    bool isForeign(const Chain& chain) const {
        for (int v = chain.first; v < chain.first + chain.count; ++v)
            if (isForeign(v)) return true;
        return false;
    }
    bool isForeign(const Crossing& crossing) const {
        return std::ranges::any_of(crossing.sides, [this](const CrossingSide& side) {
            return isForeign(side.before) || isForeign(side.after);
        });
    }

    void knowChain(int chain) {
        if (chain < 0 || known_[at(chain)] || isForeign(problem_.chains[at(chain)])) return;
        known_[at(chain)] = true;
        fresh_.push_back(chain);
    }

    /// Lines that are covered already but may still be cracked here or there play a part; and so do all
    /// crossings of the chains that do.
    void knowCovered(std::vector<int>& crossings) {
        while (!fresh_.empty()) {
            const Chain& chain = problem_.chains[at(fresh_.back())];
            fresh_.pop_back();
            for (int v = chain.first; v < chain.first + chain.count; ++v)
                for (const int id : state_.crossingsOf(v)) {
                    crossings.push_back(id);
                    const Crossing& crossing = problem_.crossings[at(id)];
                    if (anyOut(crossing)) continue;
                    for (const CrossingSide& side : crossing.sides)
                        for (const int arc : {side.before, side.after})
                            knowChain(state_.chainOf(arc));
                }
        }
        makeUnique(crossings);
    }

    bool isOut(int variable) const { return state_.value(variable) == ArcState::out; }
    bool isIn(int variable) const { return state_.value(variable) == ArcState::in; }
    bool anyOut(const Crossing& crossing) const {
        return std::ranges::any_of(crossing.sides, [this](const CrossingSide& side) {
            return isOut(side.before) || isOut(side.after);
        });
    }

    int newColumn(int variable) {
        result_.costs.push_back(state_.isFree(variable) ? problem_.costs[at(variable)] : 0);
        result_.variableOf.push_back(variable);
        return static_cast<int>(result_.costs.size()) - 1;
    }

    const Formulation::Columns& columns(int variable) const { return result_.columnsOf[at(variable)]; }

    /// What is out parts a chain: before it only one particle runs, after it only the other.
    void addChain(const Chain& chain) {
        int firstOut = chain.first + chain.count, lastOut = chain.first - 1;
        for (int v = chain.first; v < chain.first + chain.count; ++v)
            if (isOut(v)) {
                firstOut = std::min(firstOut, v);
                lastOut = v;
            }
        for (int v = chain.first; v < chain.first + chain.count; ++v) {
            if (isOut(v)) continue;
            Formulation::Columns& here = result_.columnsOf[at(v)];
            if (chain.coveredBefore && v < firstOut) here.fromBefore = newColumn(v);
            if (chain.coveredAfter && v > lastOut) here.fromAfter = newColumn(v);
            if (here.fromBefore >= 0 && here.fromAfter >= 0) {
                result_.coverRowOf[at(v)] = static_cast<int>(result_.rows.size());
                result_.rows.push_back(
                    {{here.fromBefore, here.fromAfter}, {1, 1}, isIn(v) ? 1.0 : -infinity, 1});
            }
            if (v == chain.first) continue;
            const Formulation::Columns& last = columns(v - 1);
            if (last.fromBefore >= 0 && here.fromBefore >= 0)
                atLeast(Expression{}.add(last.fromBefore, 1).add(here.fromBefore, -1), 0);
            if (last.fromAfter >= 0 && here.fromAfter >= 0)
                atLeast(Expression{}.add(here.fromAfter, 1).add(last.fromAfter, -1), 0);
        }
    }

    /// y of a variable or constant.
    Expression present(int variable) const {
        Expression expression;
        const auto& [fromBefore, fromAfter] = columns(variable);
        if (fromBefore >= 0) expression.add(fromBefore, 1);
        if (fromAfter >= 0) expression.add(fromAfter, 1);
        if (!columns(variable).any()) expression.constant = isIn(variable) ? 1 : 0;
        return expression;
    }

    /// expression >= bound, unless that says nothing.
    void atLeast(const Expression& expression, double bound) {
        Formulation::Row row{{}, {}, bound - expression.constant, infinity};
        double least = 0;
        for (const auto& [column, weight] : expression.terms) {
            if (weight == 0) continue;
            row.columns.push_back(column);
            row.weights.push_back(weight);
            least += std::min(weight, 0.0);
        }
        if (least < row.lower) result_.rows.push_back(std::move(row));
    }

    /// Nothing can crack this line here, and all of it is in: one particle passes, or two start here.
    bool isWall(const CrossingSide& side) const {
        return side.node < 0 && isIn(side.before) && isIn(side.after);
    }

    bool consecutive(const CrossingSide& side) const {
        return !isWall(side) && side.after == side.before + 1 && side.after < problem_.variables() &&
               state_.chainOf(side.before) == state_.chainOf(side.after) && columns(side.before).any() &&
               columns(side.after).any();
    }

    /// One particle passes from one arc to the next if it is still running on the second.
    Expression pass(const CrossingSide& side) const {
        Expression expression;
        if (columns(side.after).fromBefore >= 0) expression.add(columns(side.after).fromBefore, 1);
        if (columns(side.before).fromAfter >= 0) expression.add(columns(side.before).fromAfter, 1);
        return expression;
    }

    /// At most 1 if a single particle passes, and 0 if none does.
    Expression surePass(const CrossingSide& side) const {
        if (isOut(side.before) || isOut(side.after)) return {};
        if (isWall(side)) {
            Expression always;
            always.constant = 1;
            return always;
        }
        if (consecutive(side)) return pass(side);
        Expression expression;
        const bool enters = side.before == problem_.in(), leaves = side.after == problem_.in();
        if (enters && columns(side.after).fromBefore >= 0) expression.add(columns(side.after).fromBefore, 1);
        if (leaves && columns(side.before).fromAfter >= 0) expression.add(columns(side.before).fromAfter, 1);
        return expression;
    }

    void addCrossing(const Crossing& crossing) {
        if (isForeign(crossing)) return;
        if (!crossing.open) {
            for (const std::size_t k : {0U, 1U})
                addStops(crossing.sides[k], crossing.sides[1 - k]);
        }
        if (crossing.cornerCost != 0 && anyFree(crossing)) addCorners(crossing);
        if (!problem_.gaps) return;
        Expression passes = surePass(crossing.sides[0]);
        passes.add(surePass(crossing.sides[1]), 1);
        atLeast(Expression{}.add(passes, -1), -1);
    }

    bool anyFree(const Crossing& crossing) const {
        return std::ranges::any_of(crossing.sides, [this](const CrossingSide& side) {
            return state_.isFree(side.before) || state_.isFree(side.after);
        });
    }

    /// The corners at a crossing beyond those between arcs that are in already.
    void addCorners(const Crossing& crossing) {
        const auto known = [this](const CrossingSide& side) {
            return (isIn(side.before) ? 1 : 0) + (isIn(side.after) ? 1 : 0);
        };
        Expression corners = problem_.gaps ? cornersByStops(crossing) : cornersByArcs(crossing);
        corners.constant -= cornersAt(known(crossing.sides[0]), known(crossing.sides[1]));
        for (const auto& [column, weight] : corners.terms)
            result_.costs[at(column)] += crossing.cornerCost * weight;
        result_.constant += crossing.cornerCost * corners.constant;
    }

    /// Two for every particle that stops.
    Expression cornersByStops(const Crossing& crossing) const {
        Expression corners;
        for (const CrossingSide& side : crossing.sides) {
            if (consecutive(side)) {
                for (const Expression& stop : particleStops(side))
                    corners.add(stop, 2);
                continue;
            }
            // One of the arcs is known, or both are in.
            const bool beforeKnown = !columns(side.before).any();
            const int sign = isIn(beforeKnown ? side.before : side.after) ? 1 : -1;
            if (isWall(side)) continue;
            corners.add(present(beforeKnown ? side.before : side.after), 2 * sign);
            corners.add(present(beforeKnown ? side.after : side.before), -2 * sign);
        }
        return corners;
    }

    /// Two for every arc beyond the second; a new column tells when there is none.
    Expression cornersByArcs(const Crossing& crossing) {
        const int empty = static_cast<int>(result_.costs.size());
        result_.costs.push_back(0);
        result_.variableOf.push_back(-1);
        Expression corners;
        corners.constant = -4;
        corners.add(empty, 4);
        for (const CrossingSide& side : crossing.sides)
            for (const int arc : {side.before, side.after}) {
                corners.add(present(arc), 2);
                atLeast(Expression{}.add(empty, -1).add(present(arc), -1), -1);
            }
        const auto& [a, b] = crossing.sides;
        for (const int one : {a.before, a.after})
            for (const int other : {b.before, b.after})
                atLeast(Expression{}.add(empty, 1).add(present(one), 1).add(present(other), 1), 1);
        return corners;
    }

    /// The particle from before stops here, and the particle from after.
    std::array<Expression, 2> particleStops(const CrossingSide& side) const {
        const auto& before = columns(side.before);
        const auto& after = columns(side.after);
        std::array<Expression, 2> stops;
        if (before.fromBefore >= 0) stops[0].add(before.fromBefore, 1);
        if (after.fromBefore >= 0) stops[0].add(after.fromBefore, -1);
        if (after.fromAfter >= 0) stops[1].add(after.fromAfter, 1);
        if (before.fromAfter >= 0) stops[1].add(before.fromAfter, -1);
        return stops;
    }

    /// Where a track ends, the other line goes through.
    void addStops(const CrossingSide& side, const CrossingSide& wall) {
        std::array<Expression, 2> stops{present(side.before).add(present(side.after), -1),
                                        present(side.after).add(present(side.before), -1)};
        if (problem_.gaps && consecutive(side)) stops = particleStops(side);
        std::vector<Expression> walls;
        if (problem_.gaps && consecutive(wall))
            walls = {pass(wall)};
        else
            walls = {present(wall.before), present(wall.after)};
        for (const Expression& stop : stops)
            for (Expression row : walls)
                atLeast(row.add(stop, -1), 0);
    }

    const SearchState& state_;
    const Problem& problem_;
    Formulation result_;
    std::vector<bool> ours_;  ///< the variables of the part
    std::vector<bool> known_; ///< chains that get columns
    std::vector<int> fresh_;
};

} // namespace

Formulation formulate(const SearchState& state, const std::vector<int>& variables) {
    return Builder(state).build(variables);
}

} // namespace qm
