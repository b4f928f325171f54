/// \file The type of JSON values, for those who only hand them on: the library behind it takes long to
/// compile.
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace qm {

/// Keeps the order of keys.
using Json = nlohmann::ordered_json;

} // namespace qm
