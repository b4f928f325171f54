/// \file Distances from a point to a face or a patch, near a place that corresponds to it.
///
/// Every search ends once it has found a distance that is `enough`, or else with the smallest.
#pragma once

#include "check/mesh/neighbourhoods.h"
#include "check/mesh/vectors.h"
#include "check/surfaces/spline.h"

namespace qm::check {

/// From a point to a bilinear quad, by the Gauss-Newton iteration from `start`. Never less than the true
/// distance.
[[nodiscard]] double distanceToFace(const CheckedMesh& mesh, int face, Parameters start, const Place& point,
                                    double enough = 0);

/// From a point to a patch, by the Gauss-Newton iteration from the parameters. Never less than the true
/// distance.
[[nodiscard]] double distanceToPatch(const SurfacesPart::Patch& patch, Parameters parameters,
                                     const Place& point, double enough = 0);

} // namespace qm::check
