#include "cli/stage.h"

#include "document/files/files.h"
#include "document/schema/misspelt_keys.h"

namespace qm {

Stage::Stage(Tool& tool, Kind reads, Kind earliest)
    : tool_(tool), reads_(reads), earliest_(earliest), writes_(earliest) {
    tool.reads("DOCUMENT", "a document of kind " + kindName(earliest) +
                               (earliest == Kind::surfaces ? "" : " or of any later kind"));
    tool.group(Tool::generalOptions);
    tool.text("mesh", meshPath_, "FILE", "the mesh, if it is not where the document says");
    tool.group(Tool::ownOptions);
}

Stage::Stage(Tool& tool, Kind reads, Kind earliest, Kind writes) : Stage(tool, reads, earliest) {
    writes_ = writes;
    tool.writes("the document with the section " + std::string(sectionOf(writes)) +
                "; sections of later stages are dropped");
    tool.schema(kindName(writes));
}

void Stage::parse(std::string_view bytes, const std::string& path, Kind earliest) {
    document_ = parseDocument(bytes, path);
    warnOf(misspeltKeys(document_.root, kindName(requireKind(document_, earliest))));
}

void Stage::warnOf(const std::vector<std::string>& sentences) const {
    for (const std::string& sentence : sentences)
        tool_.warn(displayName(document_.path).append(": ").append(sentence));
}

const Model& Stage::read(Kind earliest, Kind reads) {
    parse(tool_.readInput(), tool_.inputPath(), earliest);
    return take(readModel(document_, reads, meshPath_));
}

const Model& Stage::readWhole() {
    parse(tool_.readInput(), tool_.inputPath(), earliest_);
    return take(readWholeModel(document_, meshPath_));
}

void Stage::readAnother(const std::string& path, const Document& before) {
    parse(readFile(path), path, earliest_);
    const auto meshOf = [](const Document& document) { return JsonPlace(document.root)["mesh"]["sha256"]; };
    inFile(displayName(path), [&] {
        if (meshOf(document_).text() != meshOf(before).text())
            meshOf(document_).fail("is of another mesh than " + displayName(before.path),
                                   "Give documents that were made from one mesh");
    });
    (void)take(readModel(document_, reads_, meshPath_));
}

const Model& Stage::take(Model model) {
    model_ = std::move(model);
    tool_.protect(model_.meshPath);
    warnOf(model_.notes);
    tool_.count("vertices", model_.mesh.n_vertices());
    tool_.count("faces", model_.mesh.n_faces());
    return model_;
}

void Stage::writeSection(Json options, Json section) {
    putSection(document_, {writes_, tool_.name(), std::move(options), std::move(section)});
    tool_.write(printDocument(std::move(document_)));
}

} // namespace qm
