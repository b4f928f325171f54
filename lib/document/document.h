/// \file A document as a whole: from bytes and back, and what every stage does to it.
#pragma once

#include "document/json.h"
#include "document/json_place.h"
#include "document/kind.h"

#include <string>
#include <string_view>

namespace qm {

struct Document {
    Json root;
    std::string path = "-"; ///< where it came from; "-" is standard input

    /// A section that must be there.
    [[nodiscard]] JsonPlace section(Kind kind) const { return JsonPlace(root)[sectionOf(kind)]; }
    [[nodiscard]] bool has(Kind kind) const { return root.contains(sectionOf(kind)); }
};

/// The version of the format.
constexpr int formatVersion = 1;

/// Reads and checks everything that a schema can say.
/// \throw FileError  with line and column, or the JSON pointer of the place
[[nodiscard]] Document parseDocument(std::string_view bytes, const std::string& path);

/// \throw Error  if the document has not come far enough for a tool that reads this kind
[[nodiscard]] Kind requireKind(const Document& document, Kind earliest);

/// A new document, with nothing but kind and version.
[[nodiscard]] Document newDocument(Kind kind);

/// What a tool adds.
struct StageEntry {
    Kind kind;        ///< whose section it writes
    std::string tool; ///< for the history
    Json options;     ///< likewise
    Json section;
};

/// Writes a section, in place of the one that was there; drops the sections of all later kinds, and their
/// tools from the history. Keys that no tool knows are kept.
void putSection(Document& document, StageEntry entry);

/// With the keys in their fixed order: kind, version, mesh, history, constraints, the sections in the order
/// of the pipe, and then all others as they stood.
[[nodiscard]] std::string printDocument(Document document);

} // namespace qm
