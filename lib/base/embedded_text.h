/// \file The text files that are compiled into the library. scripts/embed generates the sources of these
/// functions.
#pragma once

#include <span>
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

} // namespace qm
