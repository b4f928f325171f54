/// \file The version of the suite, recorded in the history of documents.
#pragma once

#include <string>

namespace qm {

/// "1.0.0"
[[nodiscard]] inline std::string version() {
    return QM_VERSION;
}

} // namespace qm
