/// \file The order in which shells list their faces.
#pragma once

#include "export/boundary.h"

namespace qm {

/// Lists the faces of every part such that, wherever smooth faces lie around a vertex that sharp edges reach,
/// each but the first comes after a neighbour of its own there, and none between two that have come already.
/// OpenCASCADE offsets faces in this order, and lets one take over a corner from its neighbours: two corners
/// that have been made apart stay apart, and the solid has a slit there. Planes come first, then cylinders,
/// cones, spheres and tori, as OpenCASCADE has it anyway. Where no order will do, few vertices are left out.
void orderFaces(Boundary& boundary);

} // namespace qm
