/// \file Linear functions of the unknowns of a system.
#pragma once

#include <cstddef>
#include <vector>

namespace qm {

/// Unknowns are points: the weights are the same for x, y and z.
struct LinearForm {
    std::vector<std::size_t> unknowns;
    std::vector<double> weights;

    /// Adds to the weight of an unknown; weights that are nothing but rounding are left out.
    void add(std::size_t unknown, double weight);
};

} // namespace qm
