/// \file From what a document holds to what its page shows.
#pragma once

#include "basecomplex/base_complex.h"
#include "bspline/splines/surfaces.h"
#include "cut/cut.h"
#include "enumerate/enumeration.h"
#include "features/features.h"
#include "layout/layout.h"
#include "view/scene.h"

#include <string>
#include <vector>

namespace qm {

/// Everything that a document may hold; null where it does not.
struct Viewed {
    std::string title;
    std::string kind; ///< "layout"
    const QuadMesh& mesh;
    const std::vector<double>& dihedralAngles;
    const BaseComplex& baseComplex; ///< without feature seeds
    const Features& features;
    const Cut* cut = nullptr;
    const Enumeration* enumeration = nullptr;
    const Layout* layout = nullptr;
    const Surfaces* surfaces = nullptr;
};

/// Linear in the mesh.
/// \param jobs  threads; the scene does not depend on it
[[nodiscard]] Scene buildScene(const Viewed& viewed, unsigned jobs);

} // namespace qm
