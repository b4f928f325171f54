/// \file Choice of the next decision of branch and bound: strong branching until pseudo-costs are reliable
/// (docs/METHOD.md#achterberg-2005).
#pragma once

#include "enumerate/optimum/part_search.h"
#include "enumerate/optimum/tuning.h"

#include <algorithm>

namespace qm {

/// Pseudo-costs, the effect of earlier branchings, which predict that of later ones: for every column the
/// mean growth of the bound per unit that the column is moved, up to 1 or down to 0.
class PseudoCosts {
public:
    explicit PseudoCosts(const ColumnValues& costs) : up_(costs.size()), down_(costs.size()) {}

    /// \param side      the value that the column was fixed to: up to `in`, or down to `out`
    /// \param distance  how far it was moved
    /// \param growth    of the bound
    void learn(ColumnId column, ArcState side, double distance, double growth) {
        Mean& mean = (side == ArcState::in ? up_ : down_)[column];
        const double rate = std::max(growth, 0.0) / std::max(distance, BranchingTuning::minDistance);
        for (Mean* each : {&mean, &all_}) {
            each->sum += rate;
            ++each->count;
        }
    }

    /// The predicted gain of branching on a column with this value.
    [[nodiscard]] double score(ColumnId column, double value) const {
        return std::max(rate(up_[column]) * (1 - value), BranchingTuning::minGrowth) *
               std::max(rate(down_[column]) * value, BranchingTuning::minGrowth);
    }

    /// The number of branchings learnt from, on the side with fewer.
    [[nodiscard]] int trust(ColumnId column) const {
        return std::min(up_[column].count, down_[column].count);
    }

private:
    struct Mean {
        double sum = 0;
        int count = 0;
    };
    /// The mean of a column; of all columns, if this one was never tried.
    [[nodiscard]] double rate(const Mean& mean) const {
        if (mean.count > 0) return mean.sum / mean.count;
        return all_.count > 0 ? all_.sum / all_.count : 1;
    }
    IdVector<ColumnId, Mean> up_;
    IdVector<ColumnId, Mean> down_;
    Mean all_;
};

/// A decision and the bounds of its two sides; the bound of a side that is too expensive is infinite.
struct BranchingChoice {
    Decision decision; ///< without a value
    double boundIn = 0;
    double boundOut = 0;
};

class Branching {
public:
    /// \param part  must outlive this
    explicit Branching(PartSearch& part) : part_(part), pseudoCosts_(part.formulation.costs) {}

    /// Chooses the column with a fractional relaxed value that promises the largest growth of the bound; if
    /// no column is fractional, any free variable.
    /// \param bound  of the current node, whose relaxation has just been solved
    BranchingChoice choose(double bound);
    /// Chooses any free variable: for relaxed solutions that are integral but no graph, and for searches that
    /// want several graphs.
    [[nodiscard]] BranchingChoice chooseAnyFree(double bound) const;

private:
    BranchingChoice probe(ColumnId column, double value, double bound, double& score);
    double probeSide(ColumnId column, ArcState side, double bound, double& growth);
    [[nodiscard]] Decision decisionOf(ColumnId column) const;

    PartSearch& part_;
    PseudoCosts pseudoCosts_;
};

} // namespace qm
