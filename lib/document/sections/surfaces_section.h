/// \file The section `surfaces`.
#pragma once

#include "bspline/splines/surfaces.h"
#include "document/json/json_place.h"

#include <string>

namespace qm {

/// The file of a scan.
struct ScanFile {
    std::string path;
    std::string sha256;
};

/// A place on a surface: patch, parameters and point.
[[nodiscard]] Json placeToJson(const LayoutPlace& place, const Point& point);

/// The figures alone, without the place that is farthest.
[[nodiscard]] Json figuresToJson(const ScanFigures& scan);

/// \param scan  the scan that the surfaces were fitted to, if any
[[nodiscard]] Json surfacesToJson(const Surfaces& surfaces, const ScanFile& scan = {});

/// Reads surfaces. Patches may have been edited: there must be one for every segment, with as many ascending
/// knots as its control points and degrees require, and with the segment's grid as its domain.
/// \param sizes  of the segments
[[nodiscard]] Surfaces readSurfaces(const QuadMesh& mesh, const std::vector<std::array<int, 2>>& sizes,
                                    const JsonPlace& section);

} // namespace qm
