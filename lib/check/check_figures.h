/// \file Are the surfaces as good as the document states?
#pragma once

#include "check/checked_document.h"
#include "check/context.h"
#include "check/report.h"

namespace qm::check {

/// Measures every patch at a lattice of 16 samples an edge, and every border at 16 samples an edge: distances
/// from the mesh's quads and vertices, gaps, angles between normals across smooth borders and across lines
/// within patches, folds. A figure that is less than what is found is a violation; what is not stated is not
/// checked. Linear in the mesh.
///
/// \param layout  must have passed its own check
/// \param part    with sound knots and control points
void checkFigures(const Context& context, const LayoutPart& layout, const SurfacesPart& part, Report& report);

} // namespace qm::check
