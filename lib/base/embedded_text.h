/// \file The text files that are compiled into the library. scripts/embed generates the sources of these
/// functions.
#pragma once

#include <algorithm>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace qm {

struct EmbeddedText {
    std::string_view name; ///< of the file, without its folder: "layout.schema.json"
    std::string_view text;
};

// Each returns all files of a kind, ordered by name.

[[nodiscard]] std::span<const EmbeddedText> embeddedSchemas();        ///< of schemas
[[nodiscard]] std::span<const EmbeddedText> embeddedPageParts();      ///< of lib/view/page, and three.js
[[nodiscard]] std::span<const EmbeddedText> embeddedBlenderScripts(); ///< of lib/cli/tools/remesh

/// The text of one of them.
/// \throw std::logic_error  if there is none of that name
[[nodiscard]] inline std::string_view textNamed(std::span<const EmbeddedText> texts, std::string_view name) {
    const auto found = std::ranges::find(texts, name, &EmbeddedText::name);
    if (found == texts.end()) throw std::logic_error("there is no embedded text " + std::string(name));
    return found->text;
}

} // namespace qm
