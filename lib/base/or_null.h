/// \file Optional values for functions that take pointers.
#pragma once

#include <optional>

namespace qm {

/// Null if there is no value.
template <class Value> [[nodiscard]] const Value* orNull(const std::optional<Value>& value) {
    return value ? &*value : nullptr;
}

} // namespace qm
