/// \file Reading the scan to which surfaces are fitted.
#pragma once

#include "bspline/reference/scan/triangle_surface.h"
#include "cli/tool.h"
#include "document/document.h"
#include "document/sections/surfaces_section.h"

#include <optional>
#include <string>

namespace qm {

struct ScanInput {
    std::optional<TriangleSurface> surface; ///< empty if no scan was given
    ScanFile file;
};

/// \param path  empty if there is no scan
/// \throw FileError  if the file is no scan, or is truncated
[[nodiscard]] ScanInput readScanInput(const Tool& tool, const std::string& path);

/// The scan to which a document's surfaces were fitted. Empty if it no longer exists, which is reported.
/// \param path  the file to use instead of the recorded one; may be empty
/// \throw FileError  if a path is given and the file differs from the recorded one
[[nodiscard]] std::optional<TriangleSurface> readRecordedScan(const Tool& tool, const Document& document,
                                                              const std::string& path);

} // namespace qm
