/// \file What a repair has done, in words.
#pragma once

#include "mesh/soup/repair.h"
#include "mesh/triangles/repair_triangles.h"

#include <string>

namespace qm {

/// "2 vertices welded, 1 face turned over".
/// \return nothing where nothing was done
[[nodiscard]] std::string repairText(const RepairReport& report);
[[nodiscard]] std::string repairText(const TriangleRepair& report);

} // namespace qm
