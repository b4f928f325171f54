#include "enumerate/integer_program.h"

#include <algorithm>

namespace qm {

void IntegerProgram::Row::add(int column, double weight) {
    const auto known = std::ranges::find(columns, column);
    if (known == columns.end()) {
        columns.push_back(column);
        weights.push_back(weight);
    } else {
        weights[static_cast<std::size_t>(known - columns.begin())] += weight;
    }
}

} // namespace qm
