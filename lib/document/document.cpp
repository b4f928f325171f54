#include "document/document.h"

#include "document/files/files.h"
#include "document/schema/schema_check.h"
#include "document/version.h"

#include <algorithm>

namespace qm {

namespace {

Kind readKind(const Json& root) {
    const JsonPlace place(root);
    if (!root.is_object()) place.fail("is no document of these tools", "Make one with qm-basecomplex");
    const auto kind = place.find("kind");
    if (!kind) place.fail("is no document of these tools: it lacks 'kind'", "Make one with qm-basecomplex");
    const std::optional<Kind> known = kindOfName(kind->text());
    if (!known) kind->fail("'" + kind->text() + "' is no kind of document");
    const JsonPlace version = place["version"];
    if (version.whole() != formatVersion)
        version.fail("is not " + std::to_string(formatVersion), "Use the version of the tools that wrote it");
    return *known;
}

} // namespace

Document parseDocument(std::string_view bytes, const std::string& path) {
    return inFile(displayName(path), [&] {
        Document document{parseJson(bytes), path};
        const Kind kind = readKind(document.root);
        validateAgainstSchema(document.root, kindName(kind));
        for (const Kind later : allKinds)
            if (later > kind && document.has(later))
                throw Error("/kind", "is " + kindName(kind) + ", but there is a section /" + sectionOf(later),
                            "Set the kind to " + kindName(later) + " or delete the section");
        return document;
    });
}

Kind requireKind(const Document& document, Kind earliest) {
    const Kind kind = readKind(document.root);
    if (kind < earliest)
        throw Error("/kind",
                    "is " + kindName(kind) + ", but " + kindName(earliest) + " or a later kind is needed",
                    std::string("Run ") + toolOf(earliest) + " first");
    return kind;
}

Document newDocument(Kind kind) {
    return {{{"kind", kindName(kind)}, {"version", formatVersion}}, "-"};
}

void putSection(Document& document, StageEntry entry) {
    Json& root = document.root;
    root["kind"] = kindName(entry.kind);
    root[sectionOf(entry.kind)] = std::move(entry.section);
    for (const Kind later : allKinds)
        if (later > entry.kind) root.erase(sectionOf(later));

    // A section's tool replaces the entry of its earlier run; only pruning adds to merging and earlier
    // pruning.
    const auto isKept = [&entry](const Json& step) {
        const std::optional<Kind> kind = kindWrittenBy(step.value("tool", ""));
        return !kind || *kind < entry.kind || (*kind == entry.kind && entry.tool == "qm-prune");
    };
    Json history = Json::array();
    for (Json& step : root["history"])
        if (isKept(step)) history.push_back(std::move(step));
    history.push_back({{"tool", entry.tool}, {"version", version()}, {"options", std::move(entry.options)}});
    root["history"] = std::move(history);
}

std::string printDocument(Document document) {
    std::vector<std::string> keys{"kind", "version", "mesh", "history", "constraints"};
    for (const Kind kind : allKinds)
        keys.emplace_back(sectionOf(kind));

    auto& members = document.root.get_ref<Json::object_t&>();
    Json::object_t ordered;
    const auto move = [&ordered](auto& member) { ordered.append(member.first, std::move(member.second)); };
    for (const std::string& key : keys)
        if (const auto member = members.find(key); member != members.end()) move(*member);
    for (auto& member : members)
        if (std::ranges::find(keys, member.first) == keys.end()) move(member);
    return printJson(Json(std::move(ordered)));
}

} // namespace qm
