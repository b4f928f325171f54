/// \file Equally spaced numbers at which to evaluate something.
#pragma once

#include <vector>

namespace qm::test {

/// `first`, `first` + `step`, `first` + 2 `step` ... up to `last`.
inline std::vector<double> steps(double first, double last, double step) {
    std::vector<double> numbers;
    while (first + step * static_cast<double>(numbers.size()) <= last)
        numbers.push_back(first + step * static_cast<double>(numbers.size()));
    return numbers;
}

} // namespace qm::test
