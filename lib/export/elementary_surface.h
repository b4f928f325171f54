/// \file Simple shapes as the surfaces of OpenCASCADE.
#pragma once

#include "export/patch_cloud.h"
#include "export/simple_shape.h"

#include <Geom_ElementarySurface.hxx>

namespace qm {

/// The shape's surface, turned so that its seam, its poles and its apex keep away from a patch on it.
/// \param shape  in the cloud's frame
/// \return null if nothing keeps them away, or if a radius is more than ten times the cloud's size
[[nodiscard]] Handle(Geom_ElementarySurface) elementarySurface(SimpleShape shape, const PatchCloud& cloud);

} // namespace qm
