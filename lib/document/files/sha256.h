/// \file The hash by which a document identifies its mesh.
#pragma once

#include <string>
#include <string_view>

namespace qm {

/// SHA-256 in 64 lower-case hexadecimal digits.
[[nodiscard]] std::string sha256(std::string_view bytes);

} // namespace qm
