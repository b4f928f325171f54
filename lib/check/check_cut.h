/// \file Is this a division of the mesh, and are its figures right? (docs/METHOD.md#mesh-cut)
#pragma once

#include "check/checked_document.h"
#include "check/lines.h"
#include "check/report.h"

#include <vector>

namespace qm::check {

/// Every vertex belongs to one sub-mesh, and every sub-mesh has vertices.
/// \return  whether `part.labels` can be used
[[nodiscard]] bool checkLabels(const Neighbourhoods& around, const CutPart& part, Report& report);

/// U, n_j and the terminals of every sub-mesh.
/// \param networks  the lines of every sub-mesh
void checkSubMeshes(const Neighbourhoods& around, const std::vector<LineNetwork>& networks,
                    const CutPart& part, Report& report);

} // namespace qm::check
