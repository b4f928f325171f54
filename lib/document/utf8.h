/// \file Whether text can stand in a JSON document.
#pragma once

#include <string_view>

namespace qm {

/// Well-formed UTF-8: no stray or missing continuation bytes, no overlong forms, no surrogates.
[[nodiscard]] bool isUtf8(std::string_view text);

} // namespace qm
