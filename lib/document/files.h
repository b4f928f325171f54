/// \file Reading whole files.
#pragma once

#include <string>

namespace qm {

/// The bytes of a file; "-" is standard input.
/// \throw FileError  if it cannot be read, is a folder, or larger than any document or mesh can be
[[nodiscard]] std::string readFile(const std::string& path);

/// How messages call a file: its path, or "standard input".
[[nodiscard]] std::string displayName(const std::string& path);

} // namespace qm
