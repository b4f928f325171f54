/// \file Exact numbers of motorcycle graphs (method 2).
#pragma once

#include "base/control.h"
#include "enumerate/enumeration.h"
#include "enumerate/problem.h"

namespace qm {

/// The number of graphs: parts that do not touch are counted one by one and multiplied, and whatever a
/// decision leaves apart is counted apart again. \return nothing if `control.stopRequested` ended it
[[nodiscard]] std::optional<BigCount> countGraphs(const Problem& problem, const Control& control = {});

} // namespace qm
