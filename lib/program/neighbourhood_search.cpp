#include "program/neighbourhood_search.h"

#include "base/deadline.h"
#include "program/solve_program.h"

#include <algorithm>
#include <random>

namespace qm {
namespace {

constexpr std::size_t firstSize = 250; ///< columns of a neighbourhood
constexpr std::size_t longRow = 40;    ///< the columns of a longer row do not count as neighbours
constexpr double solveSeconds = 1;     ///< for one neighbourhood
constexpr int patience = 12;           ///< neighbourhoods without success before they grow

class NeighbourhoodSearch {
public:
    NeighbourhoodSearch(const IntegerProgram& program, std::vector<double> values)
        : program_(program), values_(std::move(values)), rowsOf_(program.costs.size()),
          place_(program.costs.size(), -1) {
        for (std::size_t row = 0; row < program.rows.size(); ++row)
            for (const int column : program.rows[row].columns)
                rowsOf_[static_cast<std::size_t>(column)].push_back(row);
    }

    [[nodiscard]] std::size_t columns() const { return program_.costs.size(); }
    [[nodiscard]] const std::vector<double>& values() const { return values_; }

    /// The columns nearest to the sources.
    [[nodiscard]] std::vector<int> around(const std::vector<int>& sources, std::size_t size) const {
        std::vector<bool> seen(columns(), false);
        std::vector<int> found;
        const auto see = [&](int column) {
            if (seen[static_cast<std::size_t>(column)] || found.size() >= size) return;
            seen[static_cast<std::size_t>(column)] = true;
            found.push_back(column);
        };
        std::ranges::for_each(sources, see);
        for (std::size_t k = 0; k < found.size() && found.size() < size; ++k)
            for (const std::size_t row : rowsOf_[static_cast<std::size_t>(found[k])])
                if (program_.rows[row].columns.size() <= longRow)
                    std::ranges::for_each(program_.rows[row].columns, see);
        return found;
    }

    /// \return whether the values became better
    bool solve(const std::vector<int>& free, double seconds, const Control& control) {
        std::vector<double> start;
        start.reserve(free.size());
        for (const int column : free)
            start.push_back(values_[static_cast<std::size_t>(column)]);
        const IntegerProgram part = restrictedTo(free);
        const double before = part.cost(start);
        const ProgramSolution solution = solveProgram(part, start, seconds, control);
        if (!solution.values) return false;
        const double after = part.cost(*solution.values);
        if (after > before - 1e-9) return false;
        for (std::size_t k = 0; k < free.size(); ++k)
            values_[static_cast<std::size_t>(free[k])] = (*solution.values)[k];
        return true;
    }

private:
    /// The program in which all other columns keep their values.
    IntegerProgram restrictedTo(const std::vector<int>& free) {
        IntegerProgram part;
        std::vector<std::size_t> rows;
        for (std::size_t k = 0; k < free.size(); ++k) {
            const auto column = static_cast<std::size_t>(free[k]);
            place_[column] = static_cast<int>(k);
            part.costs.push_back(program_.costs[column]);
            rows.insert(rows.end(), rowsOf_[column].begin(), rowsOf_[column].end());
        }
        std::ranges::sort(rows);
        rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
        for (const std::size_t row : rows)
            part.rows.push_back(restricted(program_.rows[row]));
        for (const int column : free)
            place_[static_cast<std::size_t>(column)] = -1;
        return part;
    }

    IntegerProgram::Row restricted(const IntegerProgram::Row& row) const {
        IntegerProgram::Row part{{}, {}, row.lower, row.upper};
        for (std::size_t k = 0; k < row.columns.size(); ++k) {
            const auto column = static_cast<std::size_t>(row.columns[k]);
            if (place_[column] >= 0) {
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
    std::vector<double> values_;
    std::vector<std::vector<std::size_t>> rowsOf_;
    std::vector<int> place_; ///< in the part that is being made, -1 elsewhere
};

} // namespace

std::vector<double> improveByNeighbourhoods(const IntegerProgram& program, std::vector<double> values,
                                            const std::vector<std::vector<int>>& groups, double seconds,
                                            const Control& control) {
    const Deadline deadline(control, seconds);
    const Control inTime = deadline.control();
    NeighbourhoodSearch search(program, std::move(values));
    std::mt19937 random; // NOLINT(cert-msc51-cpp): the same neighbourhoods in every run
    std::size_t size = firstSize;
    for (int turn = 0, inVain = 0; search.columns() > 0 && !inTime.stopRequested(); ++turn) {
        std::vector<int> sources{static_cast<int>(random() % search.columns())};
        if (turn % 2 == 1 && !groups.empty()) sources = groups[random() % groups.size()];
        const std::vector<int> free = search.around(sources, size);
        const bool better = search.solve(free, std::min(solveSeconds, seconds), inTime);
        inVain = better ? 0 : inVain + 1;
        if (inVain < patience) continue;
        if (size >= search.columns()) break;
        size *= 2;
        inVain = 0;
    }
    return search.values();
}

} // namespace qm
