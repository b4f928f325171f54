/// \file Making quads of the triangles of a scan with Blender, for qm-remesh.
#pragma once

#include "cli/tool.h"
#include "cli/tools/quadriflow.h"

namespace qm {

/// Reads triangles, repairs them, and writes the quads that Blender makes of them. Says what else was done;
/// warns of other boundary loops than the scan's, of parts of the scan that the quads leave out, and of quads
/// that lie elsewhere.
/// \return the exit status: `exitUnmet` if quads are missing or lie elsewhere
[[nodiscard]] int remeshInput(const Tool& tool, const RemeshOptions& options);

} // namespace qm
