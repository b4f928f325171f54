/// \file Reading a quad mesh from the bytes of a file.
///
/// OBJ, OFF and PLY. The formats are read here because OpenMesh's own readers return points in single
/// precision, drop or split what they cannot represent, accept truncated files, and name no lines in errors.
#pragma once

#include "mesh/quad_mesh.h"
#include "mesh/soup/repair.h"

#include <string_view>

namespace qm {

struct ReadOptions {
    bool repair = false; ///< repair defects that can be repaired without guessing
};

struct ReadResult {
    QuadMesh mesh;
    RepairReport repair;
};

/// \param name  of the file; its extension determines the format, or, if there is none, the first word
/// \throw Error  with the first offending line, face, edge or vertex
[[nodiscard]] ReadResult readMesh(std::string_view bytes, std::string_view name,
                                  const ReadOptions& options = {});

} // namespace qm
