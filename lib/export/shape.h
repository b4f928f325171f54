/// \file Surfaces as a boundary representation: OpenCASCADE faces that share their edges.
#pragma once

#include "export/export.h"
#include "export/face_patches.h"

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
/// tolerance of the edge that they share. Patches that are plane become planes.
/// \param faces  none touches itself, see separate.h
/// \param simplify  the largest distance between a patch and the cylinder, cone, sphere, torus or plane that
/// takes its place; 0 for none of them but exact planes
[[nodiscard]] BoundaryShape buildShape(const QuadMesh& mesh, const FacePatches& faces, double simplify = 0);

} // namespace qm
