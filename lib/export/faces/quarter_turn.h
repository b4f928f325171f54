/// \file Faces seen from another side.
#pragma once

#include "export/faces/face_patches.h"

namespace qm {

/// Seen so that side 1 is side 0.
[[nodiscard]] Segment quarterTurned(const Segment& segment);
[[nodiscard]] Patch quarterTurned(const Patch& patch);

/// Turns faces that have more knots along u than along v. OpenCASCADE computes volumes with as many points in
/// both directions as suit the knots along v: where those along u were many more, volumes were wrong by up to
/// a fifth.
[[nodiscard]] FacePatches withMoreKnotsAlongV(FacePatches faces);

} // namespace qm
