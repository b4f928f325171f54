#include "program/decomposition_bound.h"

#include "base/deadline.h"
#include "base/infinity.h"
#include "base/parallel.h"
#include "program/solve_program.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <queue>

namespace qm {
namespace {

/// A partition of the columns into sets whose columns are tied by rows.
struct Clusters {
    std::vector<std::vector<ColumnId>> members;
    IdVector<ColumnId, std::size_t> clusterOf;
    IdVector<ColumnId, ColumnId> indexOf; ///< of every column in its cluster
};

class ClusterBuilder {
public:
    ClusterBuilder(const RelaxedProgram& relaxed, std::size_t columns)
        : relaxed_(relaxed), columns_(columns), rowsOf_(relaxed.program.rowsOfColumns()),
          gains_(relaxed.values.size(), 0), taken_(relaxed.values.size(), false) {}

    Clusters build() {
        Clusters clusters;
        for (const ColumnId column : taken_.ids())
            if (!taken_[column]) clusters.members.push_back(grow(column));
        // Easy clusters come first, so that the time which they do not need is left for the others.
        std::ranges::stable_sort(clusters.members, {}, [this](const auto& members) {
            return std::ranges::count_if(members,
                                         [this](ColumnId c) { return isFractional(relaxed_.values[c]); });
        });
        clusters.clusterOf.resize(taken_.size());
        clusters.indexOf.resize(taken_.size());
        for (std::size_t k = 0; k < clusters.members.size(); ++k)
            for (ColumnId index(0); const ColumnId column : clusters.members[k]) {
                clusters.clusterOf[column] = k;
                clusters.indexOf[column] = index;
                index = index + 1;
            }
        return clusters;
    }

private:
    struct Waiting {
        double gain;
        ColumnId column;
        /// Orders the queue such that the largest gain comes first, and among equal gains the first column.
        bool operator<(const Waiting& other) const {
            return gain != other.gain ? gain < other.gain : column > other.column;
        }
    };

    /// Grows a cluster by adding the column that is tied to it most closely; large duals make rows tie
    /// closely.
    std::vector<ColumnId> grow(ColumnId start) {
        constexpr double dualWeight = 20; // relative to the number of rows
        std::vector<ColumnId> cluster, touched;
        std::priority_queue<Waiting> waiting;
        waiting.push({0, start});
        while (!waiting.empty() && cluster.size() < columns_) {
            const auto [gain, column] = waiting.top();
            waiting.pop();
            if (taken_[column] || gain < gains_[column]) continue;
            taken_[column] = true;
            cluster.push_back(column);
            for (const RowId row : rowsOf_[column])
                for (const ColumnId other : relaxed_.program.rows[row].columns) {
                    if (taken_[other]) continue;
                    gains_[other] += 1 + dualWeight * std::abs(relaxed_.duals[row]);
                    touched.push_back(other);
                    waiting.push({gains_[other], other});
                }
        }
        for (const ColumnId column : touched)
            gains_[column] = 0;
        return cluster;
    }

    const RelaxedProgram& relaxed_;
    std::size_t columns_;
    const IdVector<ColumnId, std::vector<RowId>> rowsOf_;
    ColumnValues gains_; ///< for waiting columns, how closely they are tied to the cluster
    IdVector<ColumnId, bool> taken_;
};

/// The program without the rows between clusters, which are moved into its costs.
class Decomposition {
public:
    Decomposition(const RelaxedProgram& relaxed, std::size_t columns)
        : relaxed_(relaxed), clusters_(ClusterBuilder(relaxed, columns).build()),
          costs_(relaxed.program.costs), constant_(relaxed.constant), rowsOf_(size()) {
        for (const RowId row : relaxed.program.rows.ids())
            placeRow(row);
        for (std::size_t k = 0; k < size(); ++k)
            relaxedBounds_.push_back(relaxedBoundOf(k));
    }

    [[nodiscard]] std::size_t size() const { return clusters_.members.size(); }

    /// \return the sum by which the integer optima of the clusters exceed their relaxed bounds
    double gain(double seconds, const Control& control) const {
        const Deadline end(control, seconds);
        const Control limited = end.control();
        std::vector<double> gains(size(), 0);
        std::atomic<std::size_t> left = size();
        parallelFor(size(), control.jobs, [&](std::size_t k) {
            const double rounds = std::ceil(static_cast<double>(left--) / std::max(1U, control.jobs));
            gains[k] = gainOf(k, end.secondsLeft() / rounds, limited);
        });
        return std::accumulate(gains.begin(), gains.end(), 0.0);
    }

    [[nodiscard]] double relaxedBound() const {
        return std::accumulate(relaxedBounds_.begin(), relaxedBounds_.end(), constant_);
    }

private:
    void placeRow(RowId id) {
        const IntegerProgram::Row& row = relaxed_.program.rows[id];
        const std::size_t cluster = clusters_.clusterOf[row.columns.front()];
        if (std::ranges::all_of(row.columns,
                                [&](ColumnId column) { return clusters_.clusterOf[column] == cluster; })) {
            rowsOf_[cluster].push_back(id);
        } else {
            constant_ += moveIntoCosts(row, relaxed_.duals[id], costs_);
        }
    }

    /// The bound that the duals of a cluster's rows prove; the relaxed optimum itself if they are optimal.
    [[nodiscard]] double relaxedBoundOf(std::size_t cluster) const {
        IdVector<RowId, double> duals;
        for (const RowId row : rowsOf_[cluster])
            duals.push_back(relaxed_.duals[row]);
        return dualBound(programOf(cluster), duals);
    }

    [[nodiscard]] IntegerProgram programOf(std::size_t cluster) const {
        IntegerProgram program;
        for (const ColumnId column : clusters_.members[cluster])
            program.costs.push_back(costs_[column]);
        for (const RowId row : rowsOf_[cluster]) {
            program.rows.push_back(relaxed_.program.rows[row]);
            for (ColumnId& column : program.rows.back().columns)
                column = clusters_.indexOf[column];
        }
        return program;
    }

    [[nodiscard]] double gainOf(std::size_t cluster, double seconds, const Control& control) const {
        const std::vector<ColumnId>& members = clusters_.members[cluster];
        if (control.stopRequested() ||
            std::ranges::none_of(members, [&](ColumnId c) { return isFractional(relaxed_.values[c]); }))
            return 0;
        return std::max(0.0, boundProgram(programOf(cluster), seconds, control) - relaxedBounds_[cluster]);
    }

    const RelaxedProgram& relaxed_;
    const Clusters clusters_;
    ColumnValues costs_;
    double constant_;
    std::vector<std::vector<RowId>> rowsOf_; ///< for every cluster, the rows inside it
    std::vector<double> relaxedBounds_;      ///< of every cluster
};

} // namespace

double decompositionBound(const RelaxedProgram& relaxed, const DecompositionOptions& options,
                          const Control& control) {
    const Deadline end(control, options.seconds);
    double best = -infinity;
    for (std::size_t columns = options.columns;; columns *= 2) {
        if (end.isOver() || control.stopRequested()) break;
        const Decomposition parts(relaxed, columns);
        best = std::max(best, parts.relaxedBound() + parts.gain(end.secondsLeft(), control));
        if (best >= relaxed.cutoff || columns >= std::min(options.maxColumns, relaxed.values.size())) break;
    }
    return std::min(best, relaxed.cutoff);
}

} // namespace qm
