/// \file Is this the base complex of the mesh? (docs/METHOD.md#base-complex)
#pragma once

#include "check/checked_document.h"
#include "check/lines.h"
#include "check/report.h"

namespace qm::check {

/// \param network  the lines of the whole mesh, without feature seeds
void checkBaseComplex(const Neighbourhoods& around, const LineNetwork& network, const BaseComplexPart& part,
                      Report& report);

} // namespace qm::check
