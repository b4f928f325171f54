/// \file The version of the suite, as the documents' history records it.
#pragma once

#include <string>

namespace qm {

/// "1.0.0"
[[nodiscard]] std::string version();

} // namespace qm
