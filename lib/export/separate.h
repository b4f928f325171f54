/// \file Patches cut into faces that other programs can work with.
#pragma once

#include "export/face_patches.h"

namespace qm {

/// Cuts faces along grid lines where a surface is no more than continuous (an inner knot as often as the
/// degree says), and between the places where a face touches itself: a face has every vertex once, and no
/// edge twice. Offsets and Boolean operations need the first, meshers the second. A side of hundreds of edges
/// is cut at T-joints, too. Everything else stays as it is, but for knots that are there more often than
/// needed; parts take the place of their face, row by row. Linear in the mesh.
/// \param tolerance  how far points may move where knots are removed
[[nodiscard]] FacePatches separated(const QuadMesh& mesh, FacePatches faces, double tolerance);

/// Whether a vertex is on the segment's border twice.
[[nodiscard]] bool touchesItself(const Segment& segment);

} // namespace qm
