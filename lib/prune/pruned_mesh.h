/// \file The mesh whose layouts are pruned.
#pragma once

#include "basecomplex/base_complex.h"

#include <vector>

namespace qm {

/// Everything here must outlive it.
struct PrunedMesh {
    const QuadMesh& mesh;
    const BaseComplex& complex;                ///< with the feature seeds
    const std::vector<double>& dihedralAngles; ///< by edge, radians
    const std::vector<double>& edgeCosts;      ///< by edge
};

} // namespace qm
