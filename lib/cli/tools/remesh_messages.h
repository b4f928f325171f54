/// \file What qm-remesh says of its result.
#pragma once

#include "cli/tools/quadriflow.h"

namespace qm {

class Tool;

/// Warns of other boundary loops than the scan's, of parts of the scan that the quads leave out, and of quads
/// that lie elsewhere.
/// \return the exit status: `exitUnmet` if quads are missing or lie elsewhere
[[nodiscard]] int judgeRemeshed(const Tool& tool, const Remeshed& remeshed);

} // namespace qm
