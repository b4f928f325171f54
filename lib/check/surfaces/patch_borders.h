/// \file Which patches meet at which edge of the mesh.
#pragma once

#include "check/document/checked_document.h"
#include "check/mesh/neighbourhoods.h"
#include "check/surfaces/spline.h"

#include <cstddef>
#include <vector>

namespace qm::check {

/// An edge of a segment's border: the parameters of its patch at both ends.
struct BorderPlace {
    std::size_t patch = 0;
    Parameters begin{};
    Parameters end{};
};

/// By edge: the places of the segments that it borders; two see it in opposite directions.
[[nodiscard]] std::vector<std::vector<BorderPlace>> patchBorders(const Neighbourhoods& around,
                                                                 const LayoutPart& layout);

/// \param share  of the edge, from its beginning
[[nodiscard]] SurfacePoint evaluateAlong(const SurfacesPart& part, const BorderPlace& place, double share);

} // namespace qm::check
