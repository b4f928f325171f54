/// \file The exact number of motorcycle graphs (docs/METHOD.md#decision-diagrams).
#pragma once

#include "base/big_count.h"
#include "base/control.h"
#include "enumerate/state/problem.h"

namespace qm {

/// The number of graphs, from a decision diagram or, if that would be too large, by `countByParts`.
/// \return nothing if `control.stopRequested` ended the count
[[nodiscard]] std::optional<BigCount> countGraphs(const Problem& problem, const Control& control = {});

/// The same without a diagram: decides one variable, counts the independent parts that remain one by one, and
/// multiplies their counts. Memory is linear in the problem where it falls apart soon, and quadratic at
/// worst.
[[nodiscard]] std::optional<BigCount> countByParts(const Problem& problem, const Control& control = {});

} // namespace qm
