#include "program/neighbourhood_search.h"

#include "base/deadline.h"
#include "base/sort_unique.h"
#include "program/solve_program.h"

#include <algorithm>
#include <random>

namespace qm {
namespace {

/// Limit of branch and bound for one neighbourhood.
constexpr int maxNodes = 100;
/// Rows with more columns do not make them neighbours.
constexpr std::size_t longRow = 40;
/// How many neighbourhoods without success there are before they grow.
constexpr int patience = 12;

class NeighbourhoodSearch {
public:
    NeighbourhoodSearch(const IntegerProgram& program, ColumnValues values)
        : program_(program), values_(std::move(values)), rowsOf_(program.rowsOfColumns()),
          place_(program.costs.size()) {}

    [[nodiscard]] std::size_t columns() const { return program_.costs.size(); }
    [[nodiscard]] const ColumnValues& values() const { return values_; }

    /// The columns nearest to the sources, which are among them.
    [[nodiscard]] std::vector<ColumnId> around(const std::vector<ColumnId>& sources, std::size_t size) const {
        IdVector<ColumnId, bool> seen(columns(), false);
        std::vector<ColumnId> found;
        const auto see = [&](ColumnId column) {
            if (seen[column] || found.size() >= size) return;
            seen[column] = true;
            found.push_back(column);
        };
        std::ranges::for_each(sources, see);
        for (std::size_t k = 0; k < found.size() && found.size() < size; ++k)
            for (const RowId row : rowsOf_[found[k]])
                if (program_.rows[row].columns.size() <= longRow)
                    std::ranges::for_each(program_.rows[row].columns, see);
        return found;
    }

    /// Solves the program for the free columns.
    /// \return whether the values were improved
    bool solve(const std::vector<ColumnId>& free, double seconds, const Control& control) {
        ColumnValues start;
        start.reserve(free.size());
        for (const ColumnId column : free)
            start.push_back(values_[column]);
        const IntegerProgram part = restrictedTo(free);
        const double before = part.cost(start);
        const ProgramSolution solution = solveProgram(part, start, {seconds, maxNodes}, control);
        if (!solution.values) return false;
        const double after = part.cost(*solution.values);
        constexpr double rounding = 1e-9; // for sums of costs
        if (after > before - rounding) return false;
        for (std::size_t k = 0; k < free.size(); ++k)
            values_[free[k]] = (*solution.values)[ColumnId(k)];
        return true;
    }

private:
    /// The program for the free columns, in which all other columns keep their values.
    IntegerProgram restrictedTo(const std::vector<ColumnId>& free) {
        IntegerProgram part;
        std::vector<RowId> rows;
        for (std::size_t k = 0; k < free.size(); ++k) {
            const ColumnId column = free[k];
            place_[column] = ColumnId(k);
            part.costs.push_back(program_.costs[column]);
            rows.insert(rows.end(), rowsOf_[column].begin(), rowsOf_[column].end());
        }
        sortUnique(rows);
        for (const RowId row : rows)
            part.rows.push_back(restricted(program_.rows[row]));
        for (const ColumnId column : free)
            place_[column] = {};
        return part;
    }

    IntegerProgram::Row restricted(const IntegerProgram::Row& row) const {
        IntegerProgram::Row part{{}, {}, row.lower, row.upper};
        for (std::size_t k = 0; k < row.columns.size(); ++k) {
            const ColumnId column = row.columns[k];
            if (place_[column].valid()) {
                part.columns.push_back(place_[column]);
                part.weights.push_back(row.weights[k]);
            } else {
                part.lower -= row.weights[k] * values_[column];
                part.upper -= row.weights[k] * values_[column];
            }
        }
        return part;
    }

    const IntegerProgram& program_;
    ColumnValues values_;
    const IdVector<ColumnId, std::vector<RowId>> rowsOf_;
    IdVector<ColumnId, ColumnId> place_; ///< index in the part being built; otherwise none
};

} // namespace

ColumnValues improveByNeighbourhoods(const IntegerProgram& program, ColumnValues values,
                                     const std::vector<std::vector<ColumnId>>& groups,
                                     const NeighbourhoodOptions& options, const Control& control) {
    const Deadline deadline(control, options.seconds);
    const Control inTime = deadline.control();
    NeighbourhoodSearch search(program, std::move(values));
    std::mt19937 random(options.seed);
    std::size_t size = options.columns;
    for (int turn = 0, inVain = 0; search.columns() > 0 && !inTime.stopRequested(); ++turn) {
        std::vector<ColumnId> sources{ColumnId(random() % search.columns())};
        if (turn % 2 == 1 && !groups.empty()) sources = groups[random() % groups.size()];
        const std::vector<ColumnId> free = search.around(sources, size);
        const bool better = search.solve(free, deadline.secondsLeft(), inTime);
        inVain = better ? 0 : inVain + 1;
        if (inVain < patience) continue;
        if (size >= search.columns()) break;
        size *= 2;
        inVain = 0;
    }
    return search.values();
}

} // namespace qm
