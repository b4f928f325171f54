/// \file Are these motorcycle graphs of the sub-meshes, rightly priced, sorted, and all different?
/// (docs/METHOD.md#sub-meshes)
#pragma once

#include "check/context.h"
#include "check/lines.h"
#include "check/report.h"

#include <vector>

namespace qm::check {

/// \param networks  the lines of every sub-mesh, with the feature seeds
/// \param complex   what tracks refer to by separatrix; may be null
void checkEnumeration(const Context& context, const std::vector<LineNetwork>& networks,
                      const BaseComplexPart* complex, const EnumerationPart& part, Report& report);

} // namespace qm::check
