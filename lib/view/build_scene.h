/// \file From what a document holds to what its page shows.
#pragma once

#include "basecomplex/base_complex.h"
#include "bspline/reference/scan/triangle_surface.h"
#include "bspline/splines/surfaces.h"
#include "cut/cut.h"
#include "enumerate/enumeration.h"
#include "features/features.h"
#include "layout/layout.h"
#include "view/scene.h"

#include <cstddef>
#include <optional>
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
    const TriangleSurface* scan = nullptr; ///< that the surfaces were fitted to, if it can be read
    std::optional<double> tolerance;       ///< that the surfaces were to keep to, a length
    double rho = 0;            ///< radians; borders up to this dihedral angle were to become smooth
    double maxNormalAngle = 0; ///< degrees; what is allowed between normals across smooth borders
    std::string unit = "mm";   ///< of the mesh
    /// Points that stand for all surfaces: few enough to be drawn without a graphics card.
    static constexpr std::size_t usualPoints = 120'000;
    std::size_t maxPoints = usualPoints;
};

/// Linear in the mesh.
/// \param jobs  threads; the scene does not depend on it
[[nodiscard]] Scene buildScene(const Viewed& viewed, unsigned jobs);

} // namespace qm
