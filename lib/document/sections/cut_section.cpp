#include "document/sections/cut_section.h"

#include "document/options/options_json.h"
#include "document/sections/mesh_paths.h"

namespace qm {

Json cutToJson(const Cut& cut) {
    Json section = optionsToJson(cut.options);
    Json::array_t labels, subMeshes;
    labels.reserve(cut.labels.size());
    for (const SubMeshId label : cut.labels)
        labels.emplace_back(label.value());
    section["labels"] = std::move(labels);
    for (const SubMesh& subMesh : cut.subMeshes)
        subMeshes.push_back({{"id", subMeshes.size()},
                             {"quasiComplexity", subMesh.quasiComplexity},
                             {"ordinaryJunctions", subMesh.ordinaryJunctions},
                             {"source", numberOf(subMesh.source)},
                             {"sink", numberOf(subMesh.sink)}});
    section["subMeshes"] = std::move(subMeshes);
    return section;
}

namespace {

/// Reads the options; in a document written by hand, all except chi may be missing.
CutOptions readOptions(const JsonPlace& section) {
    CutOptions options;
    describe(options, [&section](const char* name, auto& value, const Range& range, const char*) {
        using Value = std::remove_cvref_t<decltype(value)>;
        const std::optional<JsonPlace> place = section.find(keyOf(name).c_str());
        if (!place) return;
        if constexpr (std::is_enum_v<Value>) {
            readChoice(*place, value);
        } else if constexpr (std::is_same_v<Value, bool>) {
            value = place->boolean();
        } else {
            value = place->number();
            if (value < range.min || value > range.max) place->fail("is out of range, " + rangeText(range));
        }
    });
    return options;
}

} // namespace

Cut readCut(const QuadMesh& mesh, const BaseComplex& complex, const JsonPlace& section) {
    Cut cut;
    (void)section["chi"].number();
    cut.options = readOptions(section);
    const JsonPlace subMeshes = section["subMeshes"];
    const JsonPlace labels = section["labels"];
    if (subMeshes.size() == 0) subMeshes.fail("there is no sub-mesh");
    if (labels.size() != mesh.n_vertices())
        labels.fail("has " + std::to_string(labels.size()) + " entries, the mesh has " +
                    std::to_string(mesh.n_vertices()) + " vertices");
    for (const int label : labels.indices(subMeshes.size(), "sub-mesh"))
        cut.labels.emplace_back(label);
    cut.subMeshes = measureSubMeshes(mesh, complex, cut.labels, static_cast<int>(subMeshes.size()));
    for (const SubMeshId id : cut.subMeshes.ids()) {
        const JsonPlace place = subMeshes[id.idx()];
        verifyPositionId(place, id.idx());
        SubMesh& subMesh = cut.subMeshes[id];
        if (const auto source = place.find("source")) subMesh.source = vertexOrNullAt(mesh, *source);
        if (const auto sink = place.find("sink")) subMesh.sink = vertexOrNullAt(mesh, *sink);
    }
    return cut;
}

bool figuresAgree(const Cut& cut, const Json& section) {
    const Json& subMeshes = section.at("subMeshes");
    for (const SubMeshId id : cut.subMeshes.ids()) {
        const Json& entry = subMeshes.at(id.idx());
        if (!entry.contains("quasiComplexity") || !entry.contains("ordinaryJunctions")) return false;
        if (!sameCost(entry.at("quasiComplexity").get<double>(), cut.subMeshes[id].quasiComplexity))
            return false;
        if (entry.at("ordinaryJunctions") != cut.subMeshes[id].ordinaryJunctions) return false;
    }
    return true;
}

void updateFigures(const Cut& cut, Json& section) {
    for (const SubMeshId id : cut.subMeshes.ids()) {
        Json& entry = section.at("subMeshes").at(id.idx());
        entry["quasiComplexity"] = cut.subMeshes[id].quasiComplexity;
        entry["ordinaryJunctions"] = cut.subMeshes[id].ordinaryJunctions;
    }
}

SubMeshes subMeshesOf(const std::optional<Cut>& cut) {
    if (!cut) return {};
    return {cut->labels, static_cast<int>(cut->subMeshes.size())};
}

} // namespace qm
