#include "enumerate/optimum/root_relaxation.h"

#include "enumerate/optimum/tuning.h"

#include <cmath>
#include <limits>

namespace qm {

bool fixByReducedCosts(ColumnState& columns, const ColumnValues& values, const ColumnValues& reducedCosts,
                       double room) {
    if (room == std::numeric_limits<double>::infinity()) return true;
    for (const ColumnId column : values.ids()) {
        const double reduced = reducedCosts[column];
        if (columns.value(column) != ArcState::free || std::abs(reduced) <= room) continue;
        const bool low = values[column]<integral, high = values[column]> 1 - integral;
        if (low && reduced > 0 && !columns.fixColumn(column, ArcState::out)) return false;
        if (high && reduced < 0 && !columns.fixColumn(column, ArcState::in)) return false;
    }
    return true;
}

void RootRelaxation::remember(double bound) {
    bound_ = bound;
    values_ = part_.relaxation.values();
    reducedCosts_ = part_.relaxation.reducedCosts();
    basis_ = part_.relaxation.basis();
    cutoff_ = part_.incumbents.cutoff();
    state_ = part_.columns.mark();
}

bool RootRelaxation::tighten() {
    if (!isKnown() || part_.incumbents.cutoff() >= cutoff_) return true;
    cutoff_ = part_.incumbents.cutoff();
    restore();
    if (!fixByReducedCosts(part_.columns, values_, reducedCosts_, cutoff_ - bound_)) return false;
    state_ = part_.columns.mark();
    if (part_.relaxation.fixedShare(part_.columns) > TreeTuning::fixedShareToRebuild) {
        part_.relaxation = Relaxation(part_.formulation, part_.columns);
        basis_ = {};
    }
    return true;
}

Relaxation::Result RootRelaxation::solveAgain() {
    Relaxation::Result result{Relaxation::Result::Kind::tooExpensive};
    if (!tighten()) return result;
    restore();
    part_.relaxation.setBasis(basis_);
    for (int slice = 0; slice < TreeTuning::maxSlicesAgain; ++slice) {
        result =
            part_.relaxation.solve(part_.columns, part_.incumbents.cutoff(), TreeTuning::iterationsPerSlice);
        if (result.kind != Relaxation::Result::Kind::unfinished) break;
    }
    return result;
}

} // namespace qm
