#include "mesh/text_lines.h"

#include <algorithm>

namespace qm {

std::string inQuotes(std::string_view word) {
    constexpr std::size_t longest = 20;
    std::string shown(word.substr(0, longest));
    std::ranges::replace_if(
        shown, [](char c) { return c < ' ' || c > '~'; }, '?');
    return '"' + shown + (word.size() > longest ? "...\"" : "\"");
}

} // namespace qm
