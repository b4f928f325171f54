/// \file The kinds of documents, in the order of the pipe.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace qm {

/// A document of a kind holds the sections of all earlier kinds, but `features` and `cut` may be missing.
enum class Kind { basecomplex, features, cut, enumeration, layout, surfaces };

/// "layout"
[[nodiscard]] std::string kindName(Kind kind);
[[nodiscard]] std::optional<Kind> kindOfName(std::string_view name);

/// The key of the section that a kind adds: "baseComplex" for basecomplex, else the kind's name.
[[nodiscard]] const char* sectionOf(Kind kind);
/// The tool that makes a kind: "qm-enum".
[[nodiscard]] const char* toolOf(Kind kind);

} // namespace qm
