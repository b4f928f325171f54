/// \file Lists of texts as one text.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace qm {

/// "one, two, three".
/// \param textOf  makes a text of every item
template <class Items, class TextOf = std::identity>
[[nodiscard]] std::string joined(const Items& items, std::string_view separator = ", ",
                                 const TextOf& textOf = {}) {
    std::string result;
    bool first = true;
    for (const auto& item : items) {
        if (!first) result += separator;
        first = false;
        result += std::invoke(textOf, item);
    }
    return result;
}

} // namespace qm
