/// \file The kinds of documents, in the order of the pipe.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace qm {

/// A document of a kind has the sections of all earlier kinds, except that `features` and `cut` may be
/// missing.
enum class Kind { basecomplex, features, cut, enumeration, layout, surfaces };

/// "layout"
[[nodiscard]] std::string kindName(Kind kind);
[[nodiscard]] std::optional<Kind> kindOfName(std::string_view name);

/// The key of the section that a kind adds: "baseComplex" for basecomplex, otherwise the kind's name.
[[nodiscard]] const char* sectionOf(Kind kind);
/// The tool that writes a kind, such as "qm-enum".
[[nodiscard]] const char* toolOf(Kind kind);

} // namespace qm
