#include "program/gradient_relaxation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace qm {
namespace {

struct Tuning {
    /// Iterations between two looks at the bounds, which cost as much as two iterations.
    static constexpr std::size_t look = 100;
    /// A restart when the distance from the optimum has fallen by the first factor since the last one, or by
    /// the second and is growing again, or after this share of all iterations
    /// (docs/METHOD.md#applegate-2021).
    static constexpr double sufficient = 0.2;
    static constexpr double necessary = 0.8;
    static constexpr double longShare = 0.36;
    /// How far the balance between both sides moves towards what the last steps suggest, in logarithms.
    static constexpr double smoothing = 0.5;
    static constexpr double minDistance = 1e-12;
};

/// A sparse matrix, row by row or column by column.
struct Lines {
    std::vector<std::size_t> starts{0};
    std::vector<std::size_t> indices;
    std::vector<double> weights;

    void add(std::size_t index, double weight) {
        indices.push_back(index);
        weights.push_back(weight);
    }
    void end() { starts.push_back(indices.size()); }
    [[nodiscard]] std::size_t size() const { return starts.size() - 1; }
    [[nodiscard]] double product(std::size_t line, const std::vector<double>& values) const {
        double sum = 0;
        for (std::size_t k = starts[line]; k < starts[line + 1]; ++k)
            sum += weights[k] * values[indices[k]];
        return sum;
    }
    /// Steps so long that the iteration still converges (docs/METHOD.md#pock-2011).
    [[nodiscard]] std::vector<double> steps() const {
        std::vector<double> steps(size(), 1);
        for (std::size_t line = 0; line < size(); ++line) {
            double sum = 0;
            for (std::size_t k = starts[line]; k < starts[line + 1]; ++k)
                sum += std::abs(weights[k]);
            if (sum > 0) steps[line] = 1 / sum;
        }
        return steps;
    }
};

Lines rowsOf(const IntegerProgram& program) {
    Lines rows;
    for (const IntegerProgram::Row& row : program.rows) {
        for (std::size_t k = 0; k < row.columns.size(); ++k)
            rows.add(row.columns[k].idx(), row.weights[k]);
        rows.end();
    }
    return rows;
}

Lines transposed(const Lines& rows, std::size_t columns) {
    std::vector<std::vector<std::pair<std::size_t, double>>> entries(columns);
    for (std::size_t row = 0; row < rows.size(); ++row)
        for (std::size_t k = rows.starts[row]; k < rows.starts[row + 1]; ++k)
            entries[rows.indices[k]].emplace_back(row, rows.weights[k]);
    Lines lines;
    for (const auto& column : entries) {
        for (const auto& [row, weight] : column)
            lines.add(row, weight);
        lines.end();
    }
    return lines;
}

/// Values of columns and duals of rows.
struct Iterate {
    std::vector<double> values, duals;
};

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
        : costs_(program.costs.begin(), program.costs.end()), rows_(rowsOf(program)),
          columns_(transposed(rows_, costs_.size())), columnSteps_(columns_.steps()),
          rowSteps_(rows_.steps()) {
        for (const IntegerProgram::Row& row : program.rows) {
            lower_.push_back(row.lower);
            upper_.push_back(row.upper);
        }
        now_ = {std::vector<double>(costs_.size(), 0), std::vector<double>(lower_.size(), 0)};
        start_ = sums_ = now_;
        ahead_ = now_.values;
    }

    NearOptimum run(const GradientOptions& options, const Control& control) {
        for (std::size_t done = 1; done <= options.iterations && !control.stopRequested(); ++done) {
            step();
            if (done % Tuning::look != 0) continue;
            const Iterate mean = this->mean();
            const double distance = this->distance(now_), distanceOfMean = this->distance(mean);
            const double nearer = std::min(distance, distanceOfMean);
            const bool grows = nearer <= Tuning::necessary * distanceAtStart_ && nearer > lastDistance_;
            const bool isLong = static_cast<double>(steps_) > Tuning::longShare * static_cast<double>(done);
            lastDistance_ = nearer;
            if (nearer <= options.tolerance * (1 + std::abs(best_.lowerBound))) break;
            if (nearer <= Tuning::sufficient * distanceAtStart_ || grows || isLong)
                restart(distanceOfMean < distance ? mean : now_, nearer);
        }
        if (best_.values.empty()) distance(now_);
        return std::move(best_);
    }

private:
    void step() {
        for (std::size_t column = 0; column < costs_.size(); ++column) {
            const double before = now_.values[column];
            const double reduced = costs_[column] - columns_.product(column, now_.duals);
            now_.values[column] = std::clamp(before - columnSteps_[column] / balance_ * reduced, 0.0, 1.0);
            ahead_[column] = 2 * now_.values[column] - before;
            sums_.values[column] += now_.values[column];
        }
        for (std::size_t row = 0; row < lower_.size(); ++row) {
            const double length = rowSteps_[row] * balance_;
            const double wanted = rows_.product(row, ahead_) - now_.duals[row] / length;
            now_.duals[row] = length * (std::clamp(wanted, lower_[row], upper_[row]) - wanted);
            sums_.duals[row] += now_.duals[row];
        }
        ++steps_;
    }

    [[nodiscard]] Iterate mean() const {
        Iterate mean = sums_;
        for (double& value : mean.values)
            value /= static_cast<double>(steps_);
        for (double& dual : mean.duals)
            dual /= static_cast<double>(steps_);
        return mean;
    }

    void restart(Iterate from, double distance) {
        now_ = std::move(from);
        const double ofValues = squaredDistance(now_.values, start_.values, columnSteps_);
        const double ofDuals = squaredDistance(now_.duals, start_.duals, rowSteps_);
        if (ofValues > Tuning::minDistance && ofDuals > Tuning::minDistance)
            balance_ = std::pow(std::sqrt(ofDuals / ofValues), Tuning::smoothing) *
                       std::pow(balance_, 1 - Tuning::smoothing);
        start_ = now_;
        std::ranges::fill(sums_.values, 0);
        std::ranges::fill(sums_.duals, 0);
        steps_ = 0;
        distanceAtStart_ = distance;
        lastDistance_ = std::numeric_limits<double>::infinity();
    }

    /// How far it is from an optimum: the gap between what its values cost and what its duals prove,
    /// and by how much they break rows. Remembers the best bound.
    double distance(const Iterate& iterate) {
        double bound = 0, cost = 0, broken = 0;
        for (std::size_t row = 0; row < lower_.size(); ++row) {
            const double dual = iterate.duals[row], sum = rows_.product(row, iterate.values);
            if (dual != 0) bound += dual * (dual > 0 ? lower_[row] : upper_[row]);
            broken += std::max({0.0, lower_[row] - sum, sum - upper_[row]});
        }
        for (std::size_t column = 0; column < costs_.size(); ++column) {
            bound += std::min(0.0, costs_[column] - columns_.product(column, iterate.duals));
            cost += costs_[column] * iterate.values[column];
        }
        if (best_.values.empty() || bound > best_.lowerBound)
            best_ = {ColumnValues(iterate.values.begin(), iterate.values.end()),
                     IdVector<RowId, double>(iterate.duals.begin(), iterate.duals.end()), bound};
        return std::abs(cost - bound) + broken;
    }

    std::vector<double> costs_, lower_, upper_;
    const Lines rows_, columns_;
    const std::vector<double> columnSteps_, rowSteps_;
    Iterate now_, start_; ///< at the last restart
    Iterate sums_;        ///< since then
    std::vector<double> ahead_;
    double balance_ = 1; ///< of the steps of both sides
    std::size_t steps_ = 0;
    double distanceAtStart_ = std::numeric_limits<double>::infinity();
    double lastDistance_ = std::numeric_limits<double>::infinity();
    NearOptimum best_;
};

} // namespace

NearOptimum relaxByGradients(const IntegerProgram& program, const GradientOptions& options,
                             const Control& control) {
    return GradientRelaxation(program).run(options, control);
}

double dualBound(const IntegerProgram& program, const IdVector<RowId, double>& duals) {
    double bound = 0;
    ColumnValues reduced = program.costs;
    for (const RowId id : program.rows.ids()) {
        const IntegerProgram::Row& row = program.rows[id];
        const double dual = duals[id], side = dual > 0 ? row.lower : row.upper;
        if (dual == 0 || std::isinf(side)) continue;
        bound += dual * side;
        for (std::size_t k = 0; k < row.columns.size(); ++k)
            reduced[row.columns[k]] -= dual * row.weights[k];
    }
    for (const double cost : reduced)
        bound += std::min(0.0, cost);
    return bound;
}

} // namespace qm
