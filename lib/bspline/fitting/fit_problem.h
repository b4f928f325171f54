/// \file What patches are fitted to, and how they are to meet.
#pragma once

#include "bspline/network/smooth_network.h"
#include "bspline/reference/lattice/fit_target.h"
#include "bspline/splines/surfaces.h"
#include "layout/layout.h"
#include "mesh/quad_mesh.h"

#include <functional>
#include <vector>

namespace qm {

/// The largest distance of every patch from the reference in tolerances, also between the points that the fit
/// samples: values up to 1 are within the tolerance.
using Verification = std::function<std::vector<double>(const std::vector<Patch>&)>;

/// All of it must outlive the fit.
struct FitProblem {
    const QuadMesh& mesh;
    const Layout& layout;
    const SmoothNetwork& network;
    const FitTarget& reference;
    const Verification& verify;
};

} // namespace qm
