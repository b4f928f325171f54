/// \file Checking that text can be part of a JSON document.
#pragma once

#include <string_view>

namespace qm {

/// Whether text is well-formed UTF-8: no stray or missing continuation bytes, overlong forms or surrogates.
[[nodiscard]] bool isUtf8(std::string_view text);

} // namespace qm
