#include "cli/stage.h"

#include "document/misspelt_keys.h"

namespace qm {

Stage::Stage(Tool& tool, Kind reads, Kind earliest)
    : tool_(tool), reads_(reads), earliest_(earliest), writes_(earliest) {
    declareInput();
}

Stage::Stage(Tool& tool, Kind reads, Kind earliest, Kind writes)
    : tool_(tool), reads_(reads), earliest_(earliest), writes_(writes) {
    declareInput();
    tool.writes("the document with the section " + std::string(sectionOf(writes)) +
                "; sections of later stages are dropped");
    tool.schema(kindName(writes));
}

void Stage::declareInput() {
    tool_.reads("DOCUMENT", "a document of kind " + kindName(earliest_) +
                                (earliest_ == Kind::surfaces ? "" : " or of any later kind"));
    tool_.group(Tool::generalOptions);
    tool_.text("mesh", meshPath_, "FILE", "the mesh, if it is not where the document says");
    tool_.group(Tool::ownOptions);
}

void Stage::parse(Kind earliest) {
    document_ = parseDocument(tool_.readInput(), tool_.inputPath());
    const Kind kind = requireKind(document_, earliest);
    for (const std::string& sentence : misspeltKeys(document_.root, kindName(kind)))
        tool_.warn(tool_.inputName() + ": " + sentence);
}

const Model& Stage::read(Kind earliest, Kind reads) {
    parse(earliest);
    return take(readModel(document_, reads, meshPath_));
}

const Model& Stage::readWhole() {
    parse(earliest_);
    return take(readWholeModel(document_, meshPath_));
}

const Model& Stage::take(Model model) {
    model_ = std::move(model);
    tool_.protect(model_.meshPath);
    for (const std::string& note : model_.notes)
        tool_.warn(tool_.inputName() + ": " + note);
    tool_.count("vertices", static_cast<double>(model_.mesh.n_vertices()));
    tool_.count("faces", static_cast<double>(model_.mesh.n_faces()));
    return model_;
}

void Stage::writeSection(Json options, Json section) {
    putSection(document_, {writes_, tool_.name(), std::move(options), std::move(section)});
    tool_.write(printDocument(std::move(document_)));
}

} // namespace qm
