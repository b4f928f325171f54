/// \file The section `surfaces`.
#pragma once

#include "bspline/splines/surfaces.h"
#include "document/json_place.h"

#include <string>

namespace qm {

/// The file that a scan came from.
struct ScanFile {
    std::string path;
    std::string sha256;
};

/// Patch and parameters of a place, and the point there.
[[nodiscard]] Json placeToJson(const LayoutPlace& place, const Point& point);

/// \param scan  of surfaces that were fitted to one
[[nodiscard]] Json surfacesToJson(const Surfaces& surfaces, const ScanFile& scan = {});

/// Patches may have been edited: there must be one for every segment, with as many knots as its control
/// points and degrees need, in order, and with the segment's grid as their domain.
/// \param sizes  of the segments
[[nodiscard]] Surfaces readSurfaces(const QuadMesh& mesh, const std::vector<std::array<int, 2>>& sizes,
                                    const JsonPlace& section);

} // namespace qm
