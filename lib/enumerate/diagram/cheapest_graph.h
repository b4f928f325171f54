/// \file The cheapest graph of a decision diagram.
#pragma once

#include "enumerate/diagram/diagram.h"

#include <optional>
#include <vector>

namespace qm {

/// For every node the cost of the cheapest path to the end; infinity for `none`.
[[nodiscard]] std::vector<double> cheapestPaths(const Diagram& diagram);

/// The cheapest graph; of several, the first in lexicographic order of the variables, however many there are.
/// Linear in the diagram.
/// \return nothing if there is no graph
[[nodiscard]] std::optional<Assignment> cheapestGraph(const Diagram& diagram);

} // namespace qm
