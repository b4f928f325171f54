/// \file Quads that are folded, turned over or nearly so become upright (docs/METHOD.md#drawing).
#pragma once

#include "bspline/reference/scan/triangle_surface.h"
#include "mesh/quad_mesh.h"

namespace qm {

/// How upright a quad is: the sine of its flattest corner, seen along the normal in its middle, or the cosine
/// of the angle between that normal and the scan's, whichever is less. 1 for a rectangle on a plane scan,
/// negative for quads that are folded or show their back.
/// \param reach  a scan that is farther away says nothing
[[nodiscard]] double uprightness(const QuadMesh& mesh, FaceId face, const TriangleSurface& scan,
                                 double reach);

/// Moves vertices of quads that are hardly upright, along the scan, one at a time and only where that makes
/// the worst quad around the vertex better. So it ends, and no quad becomes worse than the worst one beside
/// it was. Vertices on the boundary stay on the scan's.
/// \param reach  as above, and the largest distance of a moved vertex from the scan before it is put onto it
void unfoldQuads(QuadMesh& mesh, const TriangleSurface& scan, double reach);

} // namespace qm
