/// \file How far the surfaces are from the vertices of the mesh.
#pragma once

#include "bspline/measure/paired_surfaces.h"
#include "bspline/measure/samples.h"
#include "layout/layout.h"

#include <vector>

namespace qm {

/// From every vertex of a patch's grid to the surfaces, by patch. Vertices of evened and bridged quads may
/// lie several patches away from their places in the reference.
/// \param ofReference  by patch: the largest distance of the surfaces from the reference
[[nodiscard]] std::vector<Samples> vertexDistances(const QuadMesh& mesh, const Layout& layout,
                                                   const PairedSurfaces& toReference,
                                                   const std::vector<double>& ofReference, unsigned jobs);

} // namespace qm
