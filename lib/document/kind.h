/// \file The kinds of documents, in the order of the pipe.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace qm {

/// A document of a kind has the sections of all earlier kinds, except that `features` and `cut` may be
/// missing.
enum class Kind { basecomplex, features, cut, enumeration, layout, surfaces };

inline constexpr std::array allKinds{Kind::basecomplex, Kind::features, Kind::cut,
                                     Kind::enumeration, Kind::layout,   Kind::surfaces};

/// "layout"
[[nodiscard]] std::string kindName(Kind kind);
[[nodiscard]] std::optional<Kind> kindOfName(std::string_view name);

/// The key of the section that a kind adds: "baseComplex" for basecomplex, otherwise the kind's name.
[[nodiscard]] const char* sectionOf(Kind kind);
/// The tool that writes a kind, such as "qm-enum"; "qm-merge" for layout.
[[nodiscard]] const char* toolOf(Kind kind);
/// The kind that a tool of the pipe writes, of which qm-prune is one, too; nothing for all other tools.
[[nodiscard]] std::optional<Kind> kindWrittenBy(std::string_view tool);

} // namespace qm
