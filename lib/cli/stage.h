/// \file What the tools of the pipe have in common: a document comes in, one section is added, a document
/// goes out.
#pragma once

#include "cli/tool.h"
#include "document/document.h"
#include "document/model.h"
#include "document/options_json.h"

#include <string>
#include <string_view>
#include <utility>

namespace qm {

/// Declares operand, --mesh and, if it writes documents, -o and --schema; then reads and writes for the body.
/// Must live until the body has run.
class Stage {
public:
    /// A tool that writes a document.
    /// \param reads  what the body needs of the document (see `readModel`)
    /// \param earliest  the kind that the document must have at least
    /// \param writes  the kind of the result
    Stage(Tool& tool, Kind reads, Kind earliest, Kind writes);
    /// A tool that only reads documents; what it writes is declared with `Tool::writes`.
    Stage(Tool& tool, Kind reads, Kind earliest);
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;

    /// Reads the document and its mesh.
    [[nodiscard]] const Model& read() { return read(earliest_, reads_); }
    /// Where options decide what is needed.
    [[nodiscard]] const Model& read(Kind needed) { return read(needed, needed); }
    /// The same with all sections that the document has, whatever its kind.
    [[nodiscard]] const Model& readWhole();
    /// Reads another document instead, of the same mesh as one that was read before.
    /// \throw FileError  if its mesh has other bytes
    [[nodiscard]] const Model& readAnother(const std::string& path, const Document& before);
    [[nodiscard]] const Document& document() const { return document_; }

    /// The document, to come back to it when others have been read.
    [[nodiscard]] Document release() { return std::move(document_); }
    void resume(Document document) { document_ = std::move(document); }

    /// Puts the section into the document and writes that. The document must have been read before, and
    /// cannot be read again.
    template <class Options> void write(const Options& options, Json&& section) {
        writeSection(optionsToJson(options), std::move(section));
    }

private:
    void declareInput();
    const Model& read(Kind earliest, Kind reads);
    void parse(std::string_view bytes, const std::string& path, const std::string& name, Kind earliest);
    const Model& take(Model model, const std::string& name);
    void writeSection(Json options, Json section);

    Tool& tool_;
    Kind reads_;
    Kind earliest_;
    Kind writes_;
    std::string meshPath_;
    Document document_;
    Model model_;
};

} // namespace qm
