/// \file Cuts patches into faces that other programs can process.
#pragma once

#include "export/faces/face_patches.h"

namespace qm {

/// Cuts faces along grid lines where a surface is only continuous (an inner knot with a multiplicity equal to
/// the degree), and between the places where a face touches itself, so that a face has every vertex once and
/// no edge twice. Offsets and Boolean operations need the first, meshers the second. A side of hundreds of
/// edges is also cut at T-joints. Everything else stays as it is, except that superfluous knots are removed;
/// parts replace their face, row by row. Linear in the mesh.
/// \param tolerance  largest distance by which points may move where knots are removed
[[nodiscard]] FacePatches separated(const QuadMesh& mesh, FacePatches faces, double tolerance);

/// Whether a vertex is on the segment's border twice.
[[nodiscard]] bool touchesItself(const Segment& segment);

} // namespace qm
