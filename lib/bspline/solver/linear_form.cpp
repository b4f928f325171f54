#include "bspline/solver/linear_form.h"

#include "base/positions.h"

#include <algorithm>
#include <cmath>

namespace qm {

void LinearForm::add(std::size_t unknown, double weight) {
    if (std::abs(weight) < 1e-14) return;
    const auto found = std::ranges::find(unknowns, unknown);
    if (found != unknowns.end()) {
        weights[positionIn(unknowns, found)] += weight;
        return;
    }
    unknowns.push_back(unknown);
    weights.push_back(weight);
}

} // namespace qm
