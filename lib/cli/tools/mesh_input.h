/// \file Reading the mesh at the beginning of a pipe.
#pragma once

#include "cli/tool.h"
#include "document/json/json.h"
#include "mesh/quad_mesh.h"

namespace qm {

struct MeshInput {
    QuadMesh mesh;
    Json section; ///< the section `mesh` of the new document
};

/// Reads the tool's input as a mesh, and warns if it looks like a mistake.
/// \param repair  repair what can be repaired, report the repairs, and write the mesh to NAME.repaired.obj
/// beside the tool's output (in the working directory for standard output); the document then refers to that
/// file by name. A mesh without defects is left as it is.
[[nodiscard]] MeshInput readMeshInput(const Tool& tool, bool repair);

} // namespace qm
