/// \file Reading the mesh that a pipe begins with.
#pragma once

#include "cli/tool.h"
#include "document/json.h"
#include "mesh/quad_mesh.h"

namespace qm {

struct MeshInput {
    QuadMesh mesh;
    Json section; ///< `mesh` of the new document
};

/// Reads the tool's input as a mesh; warns of what is suspicious.
/// \param repair  mend what can be mended, say what was done, and write the mended mesh to NAME.repaired.obj
/// beside the tool's output (in the working directory if that is standard output); the document then refers
/// to that file by its name. A mesh that needs no mending is left as it is.
[[nodiscard]] MeshInput readMeshInput(const Tool& tool, bool repair);

} // namespace qm
