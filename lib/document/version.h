/// \file The version of the suite, recorded in the history of documents.
#pragma once

#include <string>

namespace qm {

/// "1.0.0"
[[nodiscard]] std::string version();

} // namespace qm
