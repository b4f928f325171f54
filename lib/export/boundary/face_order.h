/// \file The order in which the faces of a shell are listed.
#pragma once

#include "export/boundary/boundary.h"

namespace qm {

/// Orders the faces of every part so that, wherever smooth faces lie around a vertex that sharp edges reach,
/// each but the first follows a neighbour of its own there, and none stands between two that precede it.
/// OpenCASCADE offsets faces in this order, and each takes over corners from its neighbours: two corners that
/// were made separately remain separate, which leaves a slit in the solid. Planes come first, then cylinders,
/// cones, spheres and tori, as in OpenCASCADE itself. Where no order satisfies all vertices, few are
/// violated.
void orderFaces(Boundary& boundary);

} // namespace qm
