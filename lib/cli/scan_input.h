/// \file Reading the scan that surfaces are fitted to.
#pragma once

#include "bspline/reference/triangle_surface.h"
#include "cli/tool.h"
#include "document/surfaces_section.h"

#include <optional>
#include <string>

namespace qm {

struct ScanInput {
    std::optional<TriangleSurface> surface; ///< empty: no scan was named
    ScanFile file;
};

/// \param path  empty if there is no scan
/// \throw FileError  if it is no scan, or not whole
[[nodiscard]] ScanInput readScanInput(const Tool& tool, const std::string& path);

} // namespace qm
