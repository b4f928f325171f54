/// \file Patches that are one surface, joined into one face.
#pragma once

#include "export/face_patches.h"

namespace qm {

/// Joins faces again and again that have a full side in common, the same knots along it, and continuous
/// derivatives across it. No face is made that touches itself. The knots at the joint are as few as its
/// smoothness allows.
/// \param tolerance  how far points of the surfaces may move for that
[[nodiscard]] FacePatches joined(FacePatches faces, double tolerance);

} // namespace qm
