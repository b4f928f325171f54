#include "enumerate/optimum/branching.h"

#include "base/infinity.h"
#include "enumerate/optimum/tuning.h"

#include <algorithm>
#include <tuple>

namespace qm {
namespace {

using Tuning = BranchingTuning;

double scoreOf(double growthIn, double growthOut) {
    return std::max(growthIn, Tuning::minGrowth) * std::max(growthOut, Tuning::minGrowth);
}

} // namespace

Decision Branching::decisionOf(ColumnId column) const {
    const VariableId variable = part_.formulation.variableOf[column];
    const bool fromBefore = part_.formulation.columnsOf[variable].fromBefore == column;
    return {variable, fromBefore ? Decision::About::fromBefore : Decision::About::fromAfter, ArcState::free};
}

BranchingChoice Branching::chooseAnyFree(double bound) const {
    const auto variable =
        std::ranges::find_if(part_.variables, [this](VariableId v) { return part_.state.isFree(v); });
    return {{*variable, Decision::About::value, ArcState::free}, bound, bound};
}

BranchingChoice Branching::choose(double bound) {
    std::vector<std::tuple<double, ColumnId, double>> candidates;
    for (const auto& [column, value] : part_.fractionalColumns())
        candidates.emplace_back(-pseudoCosts_.score(column, value), column, value);
    if (candidates.empty()) return chooseAnyFree(bound);
    std::ranges::sort(candidates);
    const Relaxation::Basis basis = part_.relaxation.basis();
    BranchingChoice best;
    double bestScore = -1;
    int probes = 0, worse = 0;
    for (const auto& [negativeScore, column, value] : candidates) {
        BranchingChoice choice{decisionOf(column), bound, bound};
        double score = -negativeScore;
        if (pseudoCosts_.trust(column) < Tuning::probesToTrust && probes < Tuning::probesPerNode &&
            !part_.isOver()) {
            ++probes;
            choice = probe(column, value, bound, score);
            part_.relaxation.setBasis(basis);
            if (std::max(choice.boundIn, choice.boundOut) == infinity) return choice;
        }
        if (score > bestScore) {
            bestScore = score;
            best = choice;
            worse = 0;
        } else if (++worse >= Tuning::worseInARow) {
            break;
        }
    }
    return best;
}

/// Fixes a column to both values in turn and solves the relaxation for a few iterations.
BranchingChoice Branching::probe(ColumnId column, double value, double bound, double& score) {
    BranchingChoice choice{decisionOf(column), bound, bound};
    double growthIn = 0, growthOut = 0;
    choice.boundIn = probeSide(column, ArcState::in, bound, growthIn);
    choice.boundOut = probeSide(column, ArcState::out, bound, growthOut);
    if (choice.boundIn < infinity) pseudoCosts_.learn(column, ArcState::in, 1 - value, growthIn);
    if (choice.boundOut < infinity) pseudoCosts_.learn(column, ArcState::out, value, growthOut);
    score = scoreOf(growthIn, growthOut);
    return choice;
}

/// \return the bound of this side, infinite if it is too expensive; `growth` is an estimate if the solver did
/// not finish
double Branching::probeSide(ColumnId column, ArcState side, double bound, double& growth) {
    const ColumnState::Mark mark = part_.columns.mark();
    double found = infinity;
    if (part_.columns.fixColumn(column, side)) {
        const Relaxation::Result result =
            part_.relaxation.solve(part_.columns, part_.incumbents.cutoff(), Tuning::iterationsPerProbe);
        if (result.kind != Relaxation::Result::Kind::tooExpensive) {
            found = result.kind == Relaxation::Result::Kind::solved ? std::max(bound, result.bound) : bound;
            growth = result.bound - bound;
        }
    }
    part_.columns.undo(mark);
    return found;
}

} // namespace qm
