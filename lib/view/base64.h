/// \file Bytes as text.
#pragma once

#include <string>
#include <string_view>

namespace qm {

/// Numbers as little-endian bytes in base64.
[[nodiscard]] std::string base64(std::string_view bytes);

} // namespace qm
