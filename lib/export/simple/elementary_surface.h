/// \file Simple shapes as the surfaces of OpenCASCADE.
#pragma once

#include "export/simple/patch_cloud.h"
#include "export/simple/simple_shape.h"

#include <Geom_ElementarySurface.hxx>

namespace qm {

/// The surface of a shape, turned so that its seam, poles and apex are away from the patch that it replaces.
/// \param shape  in the cloud's frame
/// \return null if there is no such turn, or if a radius is more than ten times the cloud's size
[[nodiscard]] Handle(Geom_ElementarySurface) elementarySurface(SimpleShape shape, const PatchCloud& cloud);

} // namespace qm
