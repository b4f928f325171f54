/// \file Reading a quad mesh from the bytes of a file.
///
/// OBJ, OFF and PLY. OpenMesh's own readers hand points over in single precision, drop or split what they
/// cannot represent, take what is left of a file that was cut off, and name no lines. So the formats are read
/// here, and OpenMesh holds the mesh.
#pragma once

#include "mesh/quad_mesh.h"
#include "mesh/repair.h"

#include <string_view>

namespace qm {

struct ReadOptions {
    bool repair = false; ///< mend what can be mended without guessing
};

struct ReadResult {
    QuadMesh mesh;
    RepairReport repair;
};

/// \param name  of the file; its extension tells the format, and where it has none the first word does
/// \throw Error  naming the first offending line, face, edge or vertex
[[nodiscard]] ReadResult readMesh(std::string_view bytes, std::string_view name,
                                  const ReadOptions& options = {});

} // namespace qm
