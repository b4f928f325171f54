/// \file A document as a whole: reading, writing, and adding the section of a stage.
#pragma once

#include "document/json/json.h"
#include "document/json/json_place.h"
#include "document/kind.h"

#include <string>
#include <string_view>

namespace qm {

struct Document {
    Json root;
    std::string path = "-"; ///< the file it was read from; "-" is standard input

    /// The section that a kind adds; throws if it is missing.
    [[nodiscard]] JsonPlace section(Kind kind) const { return JsonPlace(root)[sectionOf(kind)]; }
    [[nodiscard]] bool has(Kind kind) const { return root.contains(sectionOf(kind)); }
};

/// The version of the format.
constexpr int formatVersion = 1;

/// Reads a document and checks it against its schema.
/// \throw FileError  with line and column, or with the JSON pointer of the place
[[nodiscard]] Document parseDocument(std::string_view bytes, const std::string& path);

/// \return the kind of the document
/// \throw Error  if it comes before `earliest` in the pipe
[[nodiscard]] Kind requireKind(const Document& document, Kind earliest);

/// A new document with only kind and version.
[[nodiscard]] Document newDocument(Kind kind);

/// A section to be added to a document, and its entry in the history.
struct StageEntry {
    Kind kind;        ///< the kind whose section it is
    std::string tool; ///< for the history
    Json options;     ///< likewise
    Json section;
};

/// Adds a section or replaces it. Drops the sections of all later kinds, and their tools from the history.
/// Unknown keys are kept.
void putSection(Document& document, StageEntry entry);

/// The text of a document. Keys are in a fixed order: kind, version, mesh, history, constraints, the sections
/// in the order of the pipe, then all others in their present order.
[[nodiscard]] std::string printDocument(Document document);

} // namespace qm
