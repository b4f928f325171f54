/// \file Warnings about meshes that are valid but look like a mistake.
#pragma once

#include "mesh/quad_mesh.h"

#include <string>
#include <vector>

namespace qm {

/// One sentence, with figures and places, for each of these: coincident vertices, quads without area, quads
/// turned over, closed components that are inside out, more than ten components, more than one extraordinary
/// vertex in ten.
[[nodiscard]] std::vector<std::string> suspicions(const QuadMesh& mesh);

} // namespace qm
