/// \file What is searched: a mesh, and what is known of it before.
#pragma once

#include "basecomplex/base_complex.h"
#include "layout/constraints.h"
#include "mesh/sub_meshes.h"

#include <vector>

namespace qm {

struct SearchedMesh {
    const QuadMesh& mesh;
    const BaseComplex& complex; ///< with the feature seeds
    const std::vector<double>& dihedralAngles;
    const SubMeshes& subMeshes;
    const Constraints& constraints;
};

} // namespace qm
