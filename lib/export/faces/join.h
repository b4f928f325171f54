/// \file Joins patches that are one surface into one face.
#pragma once

#include "export/faces/face_patches.h"

namespace qm {

/// Repeatedly joins faces that share a full side, with the same knots along it and continuous derivatives
/// across it. No resulting face touches itself. The joint gets as few knots as its smoothness allows.
/// \param tolerance  largest distance by which points of the surfaces may move
[[nodiscard]] FacePatches joined(FacePatches faces, double tolerance);

} // namespace qm
