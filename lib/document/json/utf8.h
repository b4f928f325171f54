/// \file Checking that text can be part of a JSON document.
#pragma once

#include <string>
#include <string_view>

namespace qm {

/// Whether text is well-formed UTF-8: no stray or missing continuation bytes, overlong forms or surrogates.
[[nodiscard]] bool isUtf8(std::string_view text);

/// \throw Error  if a document cannot refer to a file of this name
void requireUtf8Name(const std::string& path);

} // namespace qm
