/// \file The type of JSON values, for code that only passes them on: the library itself is slow to compile.
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace qm {

template <class Key, class Value, class Compare, class Allocator> class Members;

/// Keeps the order of keys.
using Json = nlohmann::basic_json<Members>;

} // namespace qm
