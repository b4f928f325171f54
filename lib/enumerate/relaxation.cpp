#include "enumerate/relaxation.h"

#include <coin/ClpSimplex.hpp>
#include <coin/CoinPackedMatrix.hpp>

#include <cmath>

namespace qm {
namespace {

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

const double infinity = COIN_DBL_MAX;

/// A linear expression over columns and a constant.
struct Expression {
    std::vector<std::pair<int, double>> terms;
    double constant = 0;

    void add(const Expression& other, double factor) {
        for (const auto& [column, weight] : other.terms)
            add(column, factor * weight);
        constant += factor * other.constant;
    }
    void add(int column, double weight) {
        for (auto& term : terms)
            if (term.first == column) {
                term.second += weight;
                return;
            }
        terms.emplace_back(column, weight);
    }
};

} // namespace

/// Collects rows and hands them to the solver at once.
class Relaxation::Builder {
public:
    Builder(Relaxation& relaxation, const SearchState& state)
        : relaxation_(relaxation), state_(state), problem_(state.problem()) {}

    void build() {
        addColumns();
        if (problem_.gaps)
            for (const Chain& chain : problem_.chains)
                addChain(chain);
        for (const Crossing& crossing : problem_.crossings)
            addCrossing(crossing);
        const int count = static_cast<int>(costs_.size());
        CoinPackedMatrix matrix(true, rowOf_.data(), columnOf_.data(), weights_.data(),
                                static_cast<CoinBigIndex>(weights_.size()));
        matrix.setDimensions(static_cast<int>(rowLower_.size()), count);
        const std::vector<double> lower(costs_.size(), 0), upper(costs_.size(), 1);
        relaxation_.solver_->setLogLevel(0);
        relaxation_.solver_->loadProblem(matrix, lower.data(), upper.data(), costs_.data(), rowLower_.data(),
                                         rowUpper_.data());
    }

private:
    Columns& columns(int variable) { return relaxation_.columns_[at(variable)]; }
    bool hasColumn(int variable) {
        return columns(variable).fromBefore >= 0 || columns(variable).fromAfter >= 0;
    }

    int newColumn(int variable) {
        costs_.push_back(problem_.costs[at(variable)]);
        return static_cast<int>(costs_.size()) - 1;
    }

    void addColumns() {
        std::vector<const Chain*> chainOf(at(problem_.variables()), nullptr);
        for (const Chain& chain : problem_.chains)
            for (int v = chain.first; v < chain.first + chain.count; ++v)
                chainOf[at(v)] = &chain;
        for (const int variable : relaxation_.variables_) {
            const Chain& chain = *chainOf[at(variable)];
            if (chain.coveredBefore || !problem_.gaps) columns(variable).fromBefore = newColumn(variable);
            if (chain.coveredAfter && problem_.gaps) columns(variable).fromAfter = newColumn(variable);
        }
    }

    /// y of a variable or constant.
    Expression in(int variable) {
        Expression expression;
        const Columns& c = columns(variable);
        if (c.fromBefore >= 0) expression.add(c.fromBefore, 1);
        if (c.fromAfter >= 0) expression.add(c.fromAfter, 1);
        if (!hasColumn(variable)) expression.constant = state_.value(variable) == ArcState::in ? 1 : 0;
        return expression;
    }

    /// expression >= bound, unless that says nothing.
    void atLeast(const Expression& expression, double bound) {
        std::vector<int> indices;
        std::vector<double> weights;
        for (const auto& [column, weight] : expression.terms)
            if (weight != 0) {
                indices.push_back(column);
                weights.push_back(weight);
            }
        double least = expression.constant;
        for (const double weight : weights)
            least += std::min(weight, 0.0);
        if (least >= bound) return;
        addRow(indices, weights, bound - expression.constant, infinity);
    }

    int addRow(const std::vector<int>& indices, const std::vector<double>& weights, double lower,
               double upper) {
        const int row = static_cast<int>(rowLower_.size());
        rowOf_.insert(rowOf_.end(), indices.size(), row);
        columnOf_.insert(columnOf_.end(), indices.begin(), indices.end());
        weights_.insert(weights_.end(), weights.begin(), weights.end());
        rowLower_.push_back(lower);
        rowUpper_.push_back(upper);
        return row;
    }

    void addChain(const Chain& chain) {
        for (int v = chain.first; v < chain.first + chain.count; ++v) {
            Columns& here = columns(v);
            if (here.fromBefore >= 0 && here.fromAfter >= 0) {
                here.cover = addRow({here.fromBefore, here.fromAfter}, {1, 1}, -infinity, 1);
            }
            if (v + 1 == chain.first + chain.count) continue;
            const Columns& next = columns(v + 1);
            if (here.fromBefore >= 0 && next.fromBefore >= 0)
                atLeast(difference(here.fromBefore, next.fromBefore), 0);
            if (here.fromAfter >= 0 && next.fromAfter >= 0)
                atLeast(difference(next.fromAfter, here.fromAfter), 0);
        }
    }

    static Expression difference(int a, int b) {
        Expression expression;
        expression.add(a, 1);
        expression.add(b, -1);
        return expression;
    }

    void addCrossing(const Crossing& crossing) {
        bool any = false;
        for (const CrossingSide& side : crossing.sides)
            any = any || hasColumn(side.before) || hasColumn(side.after);
        if (!any) return;
        for (const std::size_t k : {0U, 1U}) {
            if (crossing.open) break;
            const CrossingSide& ends = crossing.sides[k];
            const CrossingSide& wall = crossing.sides[1 - k];
            // A track that ends here, before or after, needs both arcs of the other line.
            for (const auto& [present, absent] :
                 {std::pair(ends.before, ends.after), std::pair(ends.after, ends.before)})
                for (const int support : {wall.before, wall.after}) {
                    Expression expression = in(support);
                    expression.add(in(absent), 1);
                    expression.add(in(present), -1);
                    atLeast(expression, 0);
                }
        }
        if (problem_.gaps) forbidTwoPasses(crossing);
    }

    /// One particle passes from one arc to the next if it is still running on the second.
    std::optional<Expression> pass(const CrossingSide& side) {
        Expression expression;
        if (side.node < 0 && side.before == problem_.in() && side.after == problem_.in()) {
            expression.constant = 1; // a wall that nothing can crack
            return expression;
        }
        if (side.after != side.before + 1 || side.after >= problem_.variables()) return std::nullopt;
        const Columns& before = columns(side.before);
        const Columns& after = columns(side.after);
        if (!hasColumn(side.before) || !hasColumn(side.after)) return std::nullopt;
        if (after.fromBefore >= 0) expression.add(after.fromBefore, 1);
        if (before.fromAfter >= 0) expression.add(before.fromAfter, 1);
        return expression;
    }

    void forbidTwoPasses(const Crossing& crossing) {
        const auto a = pass(crossing.sides[0]), b = pass(crossing.sides[1]);
        if (!a || !b) return;
        Expression expression;
        expression.add(*a, -1);
        expression.add(*b, -1);
        atLeast(expression, -1);
    }

    Relaxation& relaxation_;
    const SearchState& state_;
    const Problem& problem_;
    std::vector<double> costs_;
    std::vector<int> rowOf_; ///< of every non-zero
    std::vector<int> columnOf_;
    std::vector<double> weights_;
    std::vector<double> rowLower_;
    std::vector<double> rowUpper_;
};

Relaxation::Relaxation(const SearchState& state, std::vector<int> variables)
    : variables_(std::move(variables)), columns_(state.problem().domains.size()),
      solver_(std::make_unique<ClpSimplex>()) {
    Builder(*this, state).build();
}

Relaxation::~Relaxation() = default;
Relaxation::Relaxation(Relaxation&&) noexcept = default;
Relaxation& Relaxation::operator=(Relaxation&&) noexcept = default;

std::optional<double> Relaxation::solve(const SearchState& state, const std::vector<Decision>& decisions,
                                        double cutoff) {
    for (const int variable : variables_) {
        const Columns& c = columns_[at(variable)];
        const ArcState known = state.value(variable);
        const double upper = known == ArcState::out ? 0 : 1;
        const double lower = known == ArcState::in ? 1 : 0;
        const bool both = c.cover >= 0;
        for (const int column : {c.fromBefore, c.fromAfter})
            if (column >= 0) solver_->setColumnBounds(column, both ? 0 : lower, upper);
        if (both) solver_->setRowBounds(c.cover, lower > 0 ? 1 : -infinity, 1);
    }
    for (const Decision& decision : decisions) {
        if (decision.about == Decision::About::value) continue;
        const Columns& c = columns_[at(decision.variable)];
        const int column = decision.about == Decision::About::fromBefore ? c.fromBefore : c.fromAfter;
        const double bound = decision.state == ArcState::in ? 1 : 0;
        solver_->setColumnBounds(column, bound, bound);
    }
    solver_->setDualObjectiveLimit(cutoff);
    solver_->dual();
    if (solver_->status() > 1) solver_->primal();
    if (solver_->status() == 1) return std::nullopt;
    const double bound = solver_->status() == 0 ? solver_->objectiveValue() : trivialBound(state);
    return bound < cutoff ? std::optional(bound) : std::nullopt;
}

double Relaxation::trivialBound(const SearchState& state) const {
    double bound = 0;
    for (const int variable : variables_) {
        const double cost = state.problem().costs[at(variable)];
        if (state.value(variable) == ArcState::in || (state.isFree(variable) && cost < 0)) bound += cost;
    }
    return bound;
}

std::optional<Decision> Relaxation::undecidedWalk() const {
    const double* solution = solver_->primalColumnSolution();
    std::optional<Decision> found;
    double most = 1e-6;
    for (const int variable : variables_) {
        const Columns& c = columns_[at(variable)];
        for (const auto& [column, about] : {std::pair(c.fromBefore, Decision::About::fromBefore),
                                            std::pair(c.fromAfter, Decision::About::fromAfter)}) {
            if (column < 0) continue;
            const double doubt = std::min(solution[column], 1 - solution[column]);
            if (doubt <= most) continue;
            most = doubt;
            found = Decision{variable, about, ArcState::free};
        }
    }
    return found;
}

double Relaxation::value(int variable) const {
    const Columns& c = columns_[at(variable)];
    const double* solution = solver_->primalColumnSolution();
    return (c.fromBefore >= 0 ? solution[c.fromBefore] : 0) + (c.fromAfter >= 0 ? solution[c.fromAfter] : 0);
}

std::vector<std::pair<int, ArcState>> Relaxation::fixings(double bound, double cutoff) const {
    std::vector<std::pair<int, ArcState>> result;
    const double* reduced = solver_->dualColumnSolution();
    const double* solution = solver_->primalColumnSolution();
    const double room = cutoff - bound;
    const auto stuck = [&](int column) {
        return column < 0 || (solution[column] < 1e-9 && reduced[column] > room);
    };
    for (const int variable : variables_) {
        const Columns& c = columns_[at(variable)];
        if (stuck(c.fromBefore) && stuck(c.fromAfter)) result.emplace_back(variable, ArcState::out);
        for (const int column : {c.fromBefore, c.fromAfter})
            if (column >= 0 && solution[column] > 1 - 1e-9 && -reduced[column] > room)
                result.emplace_back(variable, ArcState::in);
    }
    return result;
}

} // namespace qm
