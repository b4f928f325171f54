/// \file Whole numbers in JSON.
#pragma once

#include "document/json/json.h"

#include <cstdint>
#include <optional>

namespace qm {

/// The value as a 64-bit integer if it is whole, however it is written; otherwise nothing.
[[nodiscard]] std::optional<std::int64_t> wholeNumber(const Json& value);

} // namespace qm
