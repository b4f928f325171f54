/// \file Exact numbers of motorcycle graphs (docs/METHOD.md#decision-diagrams).
#pragma once

#include "base/big_count.h"
#include "base/control.h"
#include "enumerate/state/problem.h"

namespace qm {

/// The number of graphs: from a decision diagram, or by parts where that would be too large.
/// \return nothing if `control.stopRequested` ended it
[[nodiscard]] std::optional<BigCount> countGraphs(const Problem& problem, const Control& control = {});

/// The same in memory linear in the problem: one variable is decided, the independent parts that remain are
/// counted one by one, and their counts are multiplied.
[[nodiscard]] std::optional<BigCount> countByParts(const Problem& problem, const Control& control = {});

} // namespace qm
