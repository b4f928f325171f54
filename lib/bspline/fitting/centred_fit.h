/// \file Fits of models that lie far from the origin.
#pragma once

#include "bspline/fitting/smooth_fit.h"

namespace qm {

/// `fitSmooth`, with the model at the origin meanwhile if that is farther away than the model is large:
/// coordinates that are large beside it leave too few digits for patches that meet exactly.
[[nodiscard]] std::vector<Patch> fitCentred(const QuadMesh& mesh, const Layout& layout,
                                            const SmoothNetwork& network, const FitTarget& reference,
                                            const SmoothFitOptions& options, const Verification& verify = {},
                                            const Control& control = {});

} // namespace qm
