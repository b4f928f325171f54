#include "enumerate/optimum/node_relaxation.h"

#include "base/infinity.h"
#include "enumerate/optimum/tuning.h"

#include <algorithm>
#include <cmath>

namespace qm {
namespace {

/// Whether a fixed column has another value in the relaxed solution.
bool contradictsRelaxation(const PartSearch& part) {
    for (const ColumnId column : part.formulation.costs.ids()) {
        const ArcState known = part.columns.value(column);
        const double value = part.relaxation.values()[column];
        if ((known == ArcState::in && value < 1 - integral) || (known == ArcState::out && value > integral))
            return true;
    }
    return false;
}

} // namespace

bool fixByReducedCosts(ColumnState& columns, const ColumnValues& values, const ColumnValues& reducedCosts,
                       double room) {
    if (room == infinity) return true;
    for (const ColumnId column : values.ids()) {
        const double reduced = reducedCosts[column];
        if (columns.value(column) != ArcState::free || std::abs(reduced) <= room) continue;
        const bool low = values[column] < integral;
        const bool high = values[column] > 1 - integral;
        if (low && reduced > 0 && !columns.fixColumn(column, ArcState::out)) return false;
        if (high && reduced < 0 && !columns.fixColumn(column, ArcState::in)) return false;
    }
    return true;
}

RelaxedNode relaxNode(PartSearch& part, double& bound) {
    for (;;) {
        Relaxation::Result result;
        for (int slice = 0; slice < TreeTuning::maxSlices; ++slice) {
            result =
                part.relaxation.solve(part.columns, part.incumbents.cutoff(), TreeTuning::iterationsPerSlice);
            bound = std::max(bound, result.proven);
            if (result.kind != Relaxation::Result::Kind::unfinished || part.isOver()) break;
        }
        if (result.kind == Relaxation::Result::Kind::tooExpensive) return RelaxedNode::cut;
        if (result.kind == Relaxation::Result::Kind::unfinished) return RelaxedNode::unfinished;
        bound = std::max(bound, result.bound);
        if (!fixByReducedCosts(part.columns, part.relaxation.values(), part.relaxation.reducedCosts(),
                               part.incumbents.cutoff() - result.bound))
            return RelaxedNode::cut;
        if (!contradictsRelaxation(part)) return RelaxedNode::solved;
    }
}

} // namespace qm
