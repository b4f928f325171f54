/// \file What a long search tells those who wait for it.
#pragma once

#include <functional>

namespace qm {

/// Told now and then, from any thread, what the best result so far costs and a bound of what any costs: minus
/// infinity if nothing is known.
using KnownCost = std::function<void(double cost, double lowerBound)>;

} // namespace qm
