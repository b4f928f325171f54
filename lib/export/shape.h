/// \file Surfaces as a boundary representation: OpenCASCADE faces that share their edges.
#pragma once

#include "bspline/splines/surfaces.h"
#include "export/export.h"
#include "layout/layout.h"

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <vector>

namespace qm {

struct BoundaryShape {
    TopoDS_Shape shape;             ///< a solid or shell; a compound of them if there are several components
    std::vector<TopoDS_Face> faces; ///< in the order of the patches
    ShapeReport report;
};

/// The topology is the layout's: one face for every patch, an edge between any two vertices where borders
/// meet, used by the patches on both sides. So nothing has to be sewn, and a gap between patches becomes the
/// tolerance of the edge that they share.
/// \throw Error  if patches are not of degrees 1 to 3, those below 3 without inner knots, are not continuous,
/// or do not belong to the layout
[[nodiscard]] BoundaryShape buildShape(const QuadMesh& mesh, const Layout& layout,
                                       const std::vector<Patch>& patches);

} // namespace qm
