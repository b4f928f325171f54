/// \file How a long search reports its progress in cost and bound.
#pragma once

#include <functional>

namespace qm {

/// Called now and then, from any thread, with the cost of the best result so far and with a lower bound of
/// all costs; the bound is minus infinity while none is known.
using KnownCost = std::function<void(double cost, double lowerBound)>;

} // namespace qm
