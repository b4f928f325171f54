/// \file Reading the scan that surfaces are fitted to.
#pragma once

#include "bspline/reference/triangle_surface.h"
#include "cli/tool.h"
#include "document/document.h"
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

/// The scan that a document's surfaces were fitted to. Empty if it is not there any more, which is told.
/// \param path  to use instead of the one that is recorded; empty: none
/// \throw FileError  if a path is given that is another file
[[nodiscard]] std::optional<TriangleSurface> readRecordedScan(const Tool& tool, const Document& document,
                                                              const std::string& path);

} // namespace qm
