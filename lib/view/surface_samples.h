/// \file What is measured of surfaces at many places, for the eye.
#pragma once

#include "bspline/measure/measure.h"
#include "bspline/network/borders.h"
#include "bspline/network/smooth_network.h"
#include "bspline/reference/scan/triangle_surface.h"
#include "bspline/splines/surfaces.h"
#include "layout/layout.h"

#include <cstddef>
#include <vector>

namespace qm {

/// Points on the lattice of `FittedPatches` for every mesh edge.
/// \param maxPoints  in all, but every edge has at least one
[[nodiscard]] std::size_t latticeSteps(std::size_t faces, std::size_t maxPoints);

/// Distances of the lattice's points, patch by patch and row by row, from the reference that surfaces are
/// fitted to.
/// \param steps  lattice points for every mesh edge
/// \param jobs  threads; the result does not depend on them
[[nodiscard]] std::vector<double> distancesFromReference(const MeasuredSurfaces& surfaces, std::size_t steps,
                                                         unsigned jobs);

/// The same from the triangles of a scan, noise and all; NaN where the scan shows nothing.
/// \param cutOff  distance beyond which the scan says nothing of the surfaces
[[nodiscard]] std::vector<double> distancesFromScan(const std::vector<Patch>& patches,
                                                    const TriangleSurface& scan, double cutOff,
                                                    std::size_t steps, unsigned jobs);

/// A figure of every patch at all points of its lattice, in the same order.
[[nodiscard]] std::vector<double> onLattice(const std::vector<double>& figures, const Layout& layout,
                                            std::size_t steps);

/// Of every border edge the largest angle between the normals on both sides, in degrees; NaN for creases and
/// the mesh's boundary.
[[nodiscard]] std::vector<double> normalAngles(const QuadMesh& mesh, const Layout& layout,
                                               const std::vector<Patch>& patches,
                                               const std::vector<BorderEdge>& borders,
                                               const BorderMarks& marks);

} // namespace qm
