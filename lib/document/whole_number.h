/// \file Whole numbers in JSON.
#pragma once

#include "document/json.h"

#include <cstdint>
#include <optional>

namespace qm {

/// A whole number, however it is written, that a 64-bit integer can hold.
[[nodiscard]] std::optional<std::int64_t> wholeNumber(const Json& value);

} // namespace qm
