/// \file Quads that lie upside down on those beside them, as remeshers leave them within planes.
#pragma once

#include "mesh/quad_mesh.h"

#include <vector>

namespace qm {

/// The quads, ascending, that are turned over together with few others, or alone: where two neighbours'
/// normals are opposite, within 26 degrees, the mesh folds back on itself. Folds may be meant, such as the
/// rim of a thin fin or lens, but then what is beyond is as large, or is connected around the fold's end. So
/// the folds divide the mesh, and quads are turned over if every part that a fold separates them from has
/// four times as many.
[[nodiscard]] std::vector<FaceId> turnedOverQuads(const QuadMesh& mesh);

} // namespace qm
