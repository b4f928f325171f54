/// \file The common part of the tools in the pipe: they read a document, add one section, and write the
/// document.
#pragma once

#include "cli/tool.h"
#include "document/document.h"
#include "document/model.h"
#include "document/options/options_json.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace qm {

/// Declares the operand, --mesh and, if the tool writes documents, -o and --schema; then reads and writes for
/// the tool's body. Must live until the body has run.
class Stage {
public:
    /// A tool that writes a document.
    /// \param reads     what the body needs of the document (see `readModel`)
    /// \param earliest  the kind that the document must have at least
    /// \param writes    the kind of the result
    Stage(Tool& tool, Kind reads, Kind earliest, Kind writes);
    /// A tool that only reads documents; its output is declared with `Tool::writes`.
    Stage(Tool& tool, Kind reads, Kind earliest);
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;

    /// Reads the document and its mesh.
    [[nodiscard]] const Model& read() { return read(earliest_, reads_); }
    /// The same for tools whose options determine what is needed.
    [[nodiscard]] const Model& read(Kind needed) { return read(needed, needed); }
    /// The same with all sections of the document, whatever its kind.
    [[nodiscard]] const Model& readWhole();
    /// Replaces the document by another one, whose mesh must be that of a document read before.
    /// \throw FileError  if the bytes of its mesh differ
    void readAnother(const std::string& path, const Document& before);
    /// What was read last; an earlier model is gone.
    [[nodiscard]] const Document& document() const { return document_; }
    [[nodiscard]] const Model& model() const { return model_; }

    /// Hands over the document, so that `resume` can return to it after others have been read.
    [[nodiscard]] Document release() { return std::move(document_); }
    void resume(Document document) { document_ = std::move(document); }

    /// Adds the section to the document, which must have been read, and writes it. The document cannot be
    /// read again afterwards.
    template <class Options> void write(const Options& options, Json&& section) {
        writeSection(optionsToJson(options), std::move(section));
    }

private:
    const Model& read(Kind earliest, Kind reads);
    void parse(std::string_view bytes, const std::string& path, Kind earliest);
    void warnOf(const std::vector<std::string>& sentences) const;
    const Model& take(Model model);
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
