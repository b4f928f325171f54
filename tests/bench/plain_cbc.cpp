#include "bench/plain_cbc.h"

#include <coin/CbcModel.hpp>
#include <coin/CoinPackedMatrix.hpp>
#include <coin/OsiClpSolverInterface.hpp>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace qm::bench {
namespace {

using Terms = std::vector<std::pair<int, double>>;

class Plain {
public:
    explicit Plain(const Problem& problem)
        : problem_(problem), columns_(problem.domains.size(), std::pair(-1, -1)) {
        for (const Chain& chain : problem.chains)
            addChain(chain);
        for (const Crossing& crossing : problem.crossings)
            addCrossing(crossing);
    }

    void load(OsiClpSolverInterface& solver) const {
        CoinPackedMatrix matrix(true, rowOf_.data(), columnOf_.data(), weights_.data(),
                                static_cast<CoinBigIndex>(weights_.size()));
        matrix.setDimensions(static_cast<int>(lower_.size()), static_cast<int>(costs_.size()));
        const std::vector<double> zeros(costs_.size(), 0), ones(costs_.size(), 1);
        const std::vector<double> upper(lower_.size(), COIN_DBL_MAX);
        solver.loadProblem(matrix, zeros.data(), ones.data(), costs_.data(), lower_.data(), upper.data());
        for (int column = 0; column < static_cast<int>(costs_.size()); ++column)
            solver.setInteger(column);
    }

private:
    void addChain(const Chain& chain) {
        for (const VariableId v : chain.variables()) {
            auto& [fromBefore, fromAfter] = columns_[v];
            if (chain.coveredBefore || !problem_.gaps) fromBefore = newColumn(v);
            if (chain.coveredAfter && problem_.gaps) fromAfter = newColumn(v);
            addRow(present(v, -1), -1);
            if (problem_.domains[v] == ArcState::in) addRow(present(v, 1), 1);
            if (problem_.domains[v] == ArcState::out) addRow(present(v, -1), 0);
            if (v == chain.first || !problem_.gaps) continue;
            const auto& last = columns_[v - 1];
            if (fromBefore >= 0) addRow({{last.first, 1}, {fromBefore, -1}}, 0);
            if (fromAfter >= 0) addRow({{fromAfter, 1}, {last.second, -1}}, 0);
        }
    }

    int newColumn(VariableId variable) {
        costs_.push_back(problem_.costs[variable]);
        return static_cast<int>(costs_.size()) - 1;
    }

    Terms present(VariableId variable, double weight) const {
        Terms terms;
        for (const int column : {columns_[variable].first, columns_[variable].second})
            if (column >= 0) terms.emplace_back(column, weight);
        return terms;
    }

    /// Adds the row sum >= `lower`; columns may occur more than once.
    void addRow(const Terms& terms, double lower) {
        std::vector<std::pair<int, double>> sums;
        for (const auto& term : terms) {
            const auto same = std::find_if(sums.begin(), sums.end(),
                                           [&](const auto& sum) { return sum.first == term.first; });
            if (same == sums.end())
                sums.push_back(term);
            else
                same->second += term.second;
        }
        for (const auto& [column, weight] : sums) {
            rowOf_.push_back(static_cast<int>(lower_.size()));
            columnOf_.push_back(column);
            weights_.push_back(weight);
        }
        lower_.push_back(lower);
    }

    double constant(VariableId variable) const { return variable == problem_.in() ? 1 : 0; }

    void addCrossing(const Crossing& crossing) {
        Terms passes;
        double walls = 0;
        for (const std::size_t k : {0U, 1U}) {
            const CrossingSide& side = crossing.sides[k];
            const CrossingSide& wall = crossing.sides[1 - k];
            for (const auto& [ends, absent] :
                 {std::pair(side.before, side.after), std::pair(side.after, side.before)})
                for (const VariableId support : {wall.before, wall.after})
                    addEnd(ends, absent, support);
            addPass(side, passes, walls);
        }
        if (problem_.gaps) addRow(passes, walls - 1);
    }

    /// Adds a row: a track that ends here needs an arc of the other line.
    void addEnd(VariableId ends, VariableId absent, VariableId support) {
        Terms terms = present(support, 1);
        for (const auto& term : present(absent, 1))
            terms.push_back(term);
        for (const auto& term : present(ends, -1))
            terms.push_back(term);
        addRow(terms, constant(ends) - constant(absent) - constant(support));
    }

    void addPass(const CrossingSide& side, Terms& passes, double& walls) const {
        if (problem_.isConstant(side.after) || problem_.isConstant(side.before)) return;
        const bool seeded = !side.node.valid() && problem_.domains[side.before] == ArcState::in &&
                            problem_.domains[side.after] == ArcState::in;
        if (seeded) {
            walls += 1;
            return;
        }
        if (columns_[side.after].first >= 0) passes.emplace_back(columns_[side.after].first, -1);
        if (columns_[side.before].second >= 0) passes.emplace_back(columns_[side.before].second, -1);
    }

    const Problem& problem_;
    IdVector<VariableId, std::pair<int, int>> columns_; ///< from before and from after; -1 for none
    std::vector<double> costs_;
    std::vector<int> rowOf_;
    std::vector<int> columnOf_;
    std::vector<double> weights_;
    std::vector<double> lower_;
};

} // namespace

PlainCbcResult solveWithPlainCbc(const Problem& problem, double seconds) {
    OsiClpSolverInterface solver;
    Plain(problem).load(solver);
    solver.messageHandler()->setLogLevel(0);
    CbcModel model(solver);
    CbcMain0(model);
    const std::string limit = std::to_string(seconds);
    const char* arguments[] = {"cbc", "-log", "0", "-sec", limit.c_str(), "-solve", "-quit"};
    CbcMain1(7, arguments, model);
    PlainCbcResult result;
    result.found = model.bestSolution() != nullptr;
    result.proven = model.isProvenOptimal();
    result.cost = result.found ? model.getObjValue() : 0;
    result.lowerBound = model.getBestPossibleObjValue();
    return result;
}

} // namespace qm::bench
