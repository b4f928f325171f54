/// \file A linear program in binary variables.
#pragma once

#include <vector>

namespace qm {

struct IntegerProgram {
    /// lower <= weights . columns <= upper
    struct Row {
        std::vector<int> columns;
        std::vector<double> weights;
        double lower = 0;
        double upper = 0;

        /// Weights of the same column add up.
        void add(int column, double weight);
    };
    std::vector<double> costs; ///< of every column; all are 0 or 1
    std::vector<Row> rows;

    /// \param values  of every column
    [[nodiscard]] double cost(const std::vector<double>& values) const;
    /// Whether they obey all rows, but for rounding.
    [[nodiscard]] bool allows(const std::vector<double>& values) const;
};

/// A relaxed value closer to 0 or 1 than this is taken for it.
constexpr double integral = 1e-6;

[[nodiscard]] constexpr bool isFractional(double value) {
    return value > integral && value < 1 - integral;
}

} // namespace qm
