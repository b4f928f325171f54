#include "enumerate/optimum/root_relaxation.h"

#include "enumerate/optimum/node_relaxation.h"
#include "enumerate/optimum/tuning.h"
#include "program/gradient_relaxation.h"

#include <utility>

namespace qm {

double RootRelaxation::relaxNearly() {
    near_ = part_.relaxation.program(part_.columns);
    GradientOptions options;
    options.tolerance = part_.options.nearlySolved;
    NearOptimum found = relaxByGradients(near_->program, options, part_.control);
    near_->values = std::move(found.values);
    near_->duals = std::move(found.duals);
    part_.relaxation.takeNear(*near_, part_.columns);
    rememberPresence();
    return near_->constant + found.lowerBound;
}

void RootRelaxation::remember(double bound) {
    bound_ = bound;
    values_ = part_.relaxation.values();
    reducedCosts_ = part_.relaxation.reducedCosts();
    basis_ = part_.relaxation.basis();
    cutoff_ = part_.incumbents.cutoff();
    state_ = part_.columns.mark();
    rememberPresence();
}

void RootRelaxation::rememberPresence() {
    presence_.clear();
    for (const VariableId variable : part_.variables)
        presence_.push_back(part_.present(variable));
}

bool RootRelaxation::tighten() {
    if (!isKnown() || part_.incumbents.cutoff() >= cutoff_) return true;
    cutoff_ = part_.incumbents.cutoff();
    restore();
    if (!fixByReducedCosts(part_.columns, values_, reducedCosts_, cutoff_ - bound_)) return false;
    state_ = part_.columns.mark();
    if (part_.relaxation.fixedShare(part_.columns) > TreeTuning::fixedShareToRebuild) {
        part_.workElsewhere += part_.relaxation.work();
        part_.relaxation = Relaxation(part_.formulation, part_.columns, part_.control);
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
