/// \file The type of JSON values, for code that only passes them on: the library itself is slow to compile.
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace qm {

/// Keeps the order of keys.
using Json = nlohmann::ordered_json;

} // namespace qm
