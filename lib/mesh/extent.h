/// \file Whether a mesh has a size and a place that can be computed with.
#pragma once

#include "mesh/bounding_box.h"

namespace qm {

/// Lengths are raised to powers, whose digits must not get lost, and differences of coordinates must have
/// digits left.
/// \param box  of the vertices that faces use
/// \throw Error  if the mesh's extent is below 1e-30, a coordinate above 1e30, or the mesh more than ten
/// million times its extent away from the origin
void verifyExtent(const BoundingBox& box);

} // namespace qm
