/// \file How well neighbouring patches meet, and how well a patch meets itself at its own knot lines.
#pragma once

#include "bspline/network/borders.h"
#include "bspline/splines/surfaces.h"
#include "layout/layout.h"

#include <vector>

namespace qm {

/// Along one edge of the layout, or along lines within a patch.
struct MeetingMeasures {
    double gap = 0;             ///< largest distance between points that should be one
    std::vector<double> angles; ///< between the normals on both sides, degrees, at every sample
};

/// At so many samples, from one end of the edge to the other. Angles are those at 1/200 of the edge from its
/// ends, in place of the ends themselves, where a patch may have no normal. On the boundary of the mesh there
/// is nothing to measure.
/// \param samples  at least 2
[[nodiscard]] MeetingMeasures measureBorder(const BorderEdge& border, const Layout& layout,
                                            const std::vector<Patch>& patches, int samples);

/// Along the knot lines within a patch at which its knots are repeated so often that its tangents may jump.
/// \param samples  for every unit of the parameter along the line
[[nodiscard]] MeetingMeasures measureInnerLines(const Patch& patch, int samples);

} // namespace qm
