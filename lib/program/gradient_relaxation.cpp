#include "program/gradient_relaxation.h"

#include "base/infinity.h"
#include "program/sparse_rows.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace qm {
namespace {

struct Tuning {
    /// Iterations between two looks at how far a step moves, which cost as much as one iteration.
    static constexpr std::size_t look = 40;
    /// Iterations between two looks at the bound.
    static constexpr std::size_t lookAtBound = 200;
    /// A restart when steps have become shorter by the first factor since the last one, or by the second and
    /// are growing again, or after this share of all iterations (docs/METHOD.md#applegate-2021).
    static constexpr double sufficient = 0.2;
    static constexpr double necessary = 0.8;
    static constexpr double longShare = 0.36;
    /// How far the balance between both sides moves towards what the last steps suggest, in logarithms.
    static constexpr double smoothing = 0.5;
    static constexpr double minDistance = 1e-12;
    /// The balance between both sides at first, over the mean cost of a column.
    static constexpr double firstBalance = 100;
};

/// For every row, the longest step with which the iteration still converges (docs/METHOD.md#pock-2011).
std::vector<double> stepsOf(const SparseRows& matrix) {
    std::vector<double> steps(matrix.size(), 1);
    for (std::size_t row = 0; row < matrix.size(); ++row)
        if (const double sum = matrix.absoluteSum(row); sum > 0) steps[row] = 1 / sum;
    return steps;
}

/// Values of columns and duals of rows.
struct Iterate {
    std::vector<double> values, duals;
};

/// In the norm in which the steps are all of length one.
double squaredDistance(const std::vector<double>& a, const std::vector<double>& b,
                       const std::vector<double>& steps) {
    double sum = 0;
    for (std::size_t k = 0; k < a.size(); ++k)
        sum += (a[k] - b[k]) * (a[k] - b[k]) / steps[k];
    return sum;
}

class GradientRelaxation {
public:
    explicit GradientRelaxation(const IntegerProgram& program)
        : program_(program), costs_(program.costs.begin(), program.costs.end()), rows_(program),
          columns_(rows_.transposed(costs_.size())), columnSteps_(stepsOf(columns_)),
          rowSteps_(stepsOf(rows_)) {
        for (const IntegerProgram::Row& row : program.rows) {
            lower_.push_back(row.lower);
            upper_.push_back(row.upper);
        }
        double costs = 0;
        for (const double cost : costs_)
            costs += std::abs(cost);
        if (costs > 0) balance_ = Tuning::firstBalance * costs / static_cast<double>(costs_.size());
        now_ = {std::vector<double>(columns_.size(), 0), std::vector<double>(rows_.size(), 0)};
        start_ = next_ = now_;
        ahead_ = now_.values;
    }

    NearOptimum run(const GradientOptions& options, const Control& control) {
        best_.lowerBound = -infinity;
        distance(now_);
        for (std::size_t done = 1; done <= options.iterations && !control.stopRequested(); ++done) {
            step();
            const bool restarts = restartsAfter(done);
            if (done % Tuning::lookAtBound == 0 &&
                distance(next_) <= options.tolerance * (1 + std::abs(best_.lowerBound)))
                break;
            if (restarts)
                restart();
            else
                reflect();
        }
        distance(next_);
        best_.values.assign(next_.values.begin(), next_.values.end());
        best_.lowerBound = dualBound(program_, best_.duals);
        return std::move(best_);
    }

private:
    /// The next point by a step of both sides.
    void step() {
        for (std::size_t column = 0; column < columns_.size(); ++column) {
            const double before = now_.values[column];
            const double reduced = costs_[column] - columns_.product(column, now_.duals);
            const double next = std::clamp(before - columnSteps_[column] / balance_ * reduced, 0.0, 1.0);
            next_.values[column] = next;
            ahead_[column] = 2 * next - before;
        }
        for (std::size_t row = 0; row < rows_.size(); ++row) {
            const double length = rowSteps_[row] * balance_;
            const double wanted = rows_.product(row, ahead_) - now_.duals[row] / length;
            next_.duals[row] = length * (std::clamp(wanted, lower_[row], upper_[row]) - wanted);
        }
        ++steps_;
    }

    /// Goes twice as far as the step, and then back towards where the last restart was, ever less.
    void reflect() {
        const double share = 1 / static_cast<double>(steps_ + 1);
        const auto move = [share](std::vector<double>& now, const std::vector<double>& next,
                                  const std::vector<double>& start) {
            for (std::size_t k = 0; k < now.size(); ++k)
                now[k] = (1 - share) * (2 * next[k] - now[k]) + share * start[k];
        };
        move(now_.values, next_.values, start_.values);
        move(now_.duals, next_.duals, start_.duals);
    }

    bool restartsAfter(std::size_t done) {
        if (steps_ == 1) {
            firstLength_ = lengthOfStep();
            lastLength_ = infinity;
        }
        if (done % Tuning::look != 0 || steps_ == 1) return false;
        const double length = lengthOfStep();
        const bool grows = length <= Tuning::necessary * firstLength_ && length > lastLength_;
        lastLength_ = length;
        return length <= Tuning::sufficient * firstLength_ || grows ||
               static_cast<double>(steps_) > Tuning::longShare * static_cast<double>(done);
    }

    /// How far the step moves, in the norm in which no step is longer than the one before.
    [[nodiscard]] double lengthOfStep() const {
        double mixed = 0;
        for (std::size_t row = 0; row < rows_.size(); ++row)
            if (const double change = next_.duals[row] - now_.duals[row]; change != 0)
                mixed += change * (rows_.product(row, next_.values) - rows_.product(row, now_.values));
        return std::sqrt(std::max(0.0, balance_ * squaredDistance(next_.values, now_.values, columnSteps_) +
                                           squaredDistance(next_.duals, now_.duals, rowSteps_) / balance_ -
                                           2 * mixed));
    }

    void restart() {
        const double ofValues = squaredDistance(next_.values, start_.values, columnSteps_);
        const double ofDuals = squaredDistance(next_.duals, start_.duals, rowSteps_);
        if (ofValues > Tuning::minDistance && ofDuals > Tuning::minDistance)
            balance_ = std::pow(std::sqrt(ofDuals / ofValues), Tuning::smoothing) *
                       std::pow(balance_, 1 - Tuning::smoothing);
        now_ = start_ = next_;
        steps_ = 0;
    }

    /// How far it is from an optimum: the gap between what its values cost and what its duals prove,
    /// and by how much they break rows. Remembers the duals of the best bound.
    double distance(const Iterate& iterate) {
        double bound = 0, cost = 0, broken = 0;
        for (std::size_t row = 0; row < rows_.size(); ++row) {
            const double dual = iterate.duals[row], sum = rows_.product(row, iterate.values);
            if (dual != 0) bound += dual * (dual > 0 ? lower_[row] : upper_[row]);
            broken += std::max({0.0, lower_[row] - sum, sum - upper_[row]});
        }
        for (std::size_t column = 0; column < columns_.size(); ++column) {
            bound += std::min(0.0, costs_[column] - columns_.product(column, iterate.duals));
            cost += costs_[column] * iterate.values[column];
        }
        if (bound > best_.lowerBound) {
            best_.duals.assign(iterate.duals.begin(), iterate.duals.end());
            best_.lowerBound = bound;
        }
        return std::abs(cost - bound) + broken;
    }

    const IntegerProgram& program_;
    const std::vector<double> costs_;
    std::vector<double> lower_, upper_;
    const SparseRows rows_, columns_;
    const std::vector<double> columnSteps_, rowSteps_;
    Iterate now_, next_;
    Iterate start_; ///< at the last restart
    std::vector<double> ahead_;
    double balance_ = 1; ///< of the steps of both sides
    std::size_t steps_ = 0;
    double firstLength_ = 0, lastLength_ = 0; ///< of steps since the last restart
    NearOptimum best_;
};

} // namespace

NearOptimum relaxByGradients(const IntegerProgram& program, const GradientOptions& options,
                             const Control& control) {
    return GradientRelaxation(program).run(options, control);
}

} // namespace qm
