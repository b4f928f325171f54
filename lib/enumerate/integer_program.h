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
};

} // namespace qm
