/// \file The date that an exported file states.
#pragma once

#include <string>

namespace qm {

/// The date that an exported file states, as in "2026-11-22T10:00:00".
/// \param text  a date, with or without a time of day, UTC: "2026-11-22T10:00:00"; or "mesh" for the time at
/// which the mesh's file was last changed
/// \throw Error  if the text is neither, or if the mesh's file is missing
[[nodiscard]] std::string exportDate(const std::string& text, const std::string& meshPath);

} // namespace qm
