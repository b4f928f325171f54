/// \file A boundary representation in OpenCASCADE's classes.
#pragma once

#include "export/boundary/boundary.h"

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <vector>

namespace qm {

struct BoundaryShape {
    TopoDS_Shape shape;             ///< a solid or shell; a compound of them if there are several parts
    std::vector<TopoDS_Face> faces; ///< in the order of the boundary's
};

[[nodiscard]] BoundaryShape buildShape(const Boundary& boundary);

} // namespace qm
