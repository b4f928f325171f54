#include "document/document.h"

#include "base/positions.h"
#include "document/files/files.h"
#include "document/schema/schema_check.h"
#include "document/version.h"

#include <algorithm>
#include <array>

namespace qm {

namespace {

constexpr std::array<Kind, 6> allKinds{Kind::basecomplex, Kind::features, Kind::cut,
                                       Kind::enumeration, Kind::layout,   Kind::surfaces};

/// The tools of the pipe, in order.
constexpr std::array<std::string_view, 7> tools{"qm-basecomplex", "qm-features", "qm-cut",    "qm-enum",
                                                "qm-merge",       "qm-prune",    "qm-bspline"};

std::size_t rankOf(std::string_view tool) {
    return positionIn(tools, std::ranges::find(tools, tool));
}

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

    // The entry of an earlier run of the same tool is replaced; only pruning adds to earlier pruning.
    const std::size_t rank = rankOf(entry.tool);
    const std::size_t first = entry.tool == "qm-prune" ? rank + 1 : rank;
    Json history = Json::array();
    if (root.contains("history"))
        for (Json& step : root["history"]) {
            const std::size_t stepRank = rankOf(step.value("tool", ""));
            if (stepRank < first || stepRank == tools.size()) history.push_back(std::move(step));
        }
    history.push_back({{"tool", entry.tool}, {"version", version()}, {"options", std::move(entry.options)}});
    root["history"] = std::move(history);
}

std::string printDocument(Document document) {
    std::vector<std::string> keys{"kind", "version", "mesh", "history", "constraints"};
    for (const Kind kind : allKinds)
        keys.emplace_back(sectionOf(kind));

    auto& members = document.root.get_ref<Json::object_t&>();
    Json::object_t ordered;
    const auto move = [&ordered](auto& member) { // spares the search for the key
        ordered.Json::object_t::Container::emplace_back(member.first, std::move(member.second));
    };
    for (const std::string& key : keys)
        if (const auto member = members.find(key); member != members.end()) move(*member);
    for (auto& member : members)
        if (std::ranges::find(keys, member.first) == keys.end()) move(member);
    return printJson(Json(std::move(ordered)));
}

} // namespace qm
