/// \file Edges along which a face twists.
#pragma once

#include "export/boundary/boundary.h"

namespace qm {

/// Divides edges that bend, in the middle, if the normal of a spline face turns along them by 60 degrees
/// farther than they do; the parts again, if it still does. Who makes triangles takes as many points of an
/// edge as its own bends need, and then adds points within the face, because of its normals; where the face
/// twists, these come to lie beyond the chord between the edge's points, and triangles cross.
/// \return whether there was one
bool divideTwistedEdges(Boundary& boundary);

} // namespace qm
