#include "document/sections/enumeration_section.h"

#include "base/at.h"
#include "document/options/options.h"
#include "document/sections/mesh_paths.h"

#include <string>
#include <utility>

namespace qm {

SeparatrixIndex::SeparatrixIndex(const QuadMesh& mesh, const BaseComplex& complex)
    : starts_(mesh.n_halfedges()) {
    for (const SeparatrixId id : complex.separatrices.ids())
        starts_[at(complex.separatrices[id].halfedges.front())] = id;
}

Json graphToJson(const QuadMesh& mesh, const SeparatrixIndex& baseComplex, const MotorcycleGraph& graph) {
    Json::array_t tracks;
    for (const Track& track : graph.tracks) {
        const SeparatrixId separatrix = baseComplex.startingWith(track.halfedges.front());
        Json entry = Json::object();
        if (separatrix.valid())
            entry["separatrix"] = separatrix.value();
        else
            entry["source"] = mesh.from_vertex_handle(track.halfedges.front()).idx();
        entry["vertices"] = pathNumbers(mesh, track.halfedges);
        tracks.push_back(std::move(entry));
    }
    return {{"cost", graph.cost}, {"tracks", std::move(tracks)}};
}

Json enumerationToJson(const QuadMesh& mesh, const SeparatrixIndex& baseComplex,
                       const Enumeration& enumeration) {
    Json::array_t subMeshes;
    for (const SubMeshId id : enumeration.subMeshes.ids()) {
        if (!enumeration.part.holds(id)) continue;
        const SubMeshGraphs& subMesh = enumeration.subMeshes[id];
        Json::array_t graphs;
        for (const MotorcycleGraph& graph : subMesh.graphs)
            graphs.push_back(graphToJson(mesh, baseComplex, graph));
        Json entry{{"id", id.value()},
                   {"cost", valueOrNull(subMesh.cost)},
                   {"lowerBound", valueOrNull(subMesh.lowerBound)},
                   {"count", valueOrNull(subMesh.count)},
                   {"graphs", std::move(graphs)}};
        for (const MotorcycleGraph& graph : subMesh.samples)
            entry["samples"].push_back(graphToJson(mesh, baseComplex, graph));
        subMeshes.push_back(std::move(entry));
    }
    Json terms = Json::object();
    forEachTerm(enumeration.cost.terms, [&](const char* name, double weight) { terms[name] = weight; });
    Json section{{"alpha", enumeration.cost.alpha},
                 {"epsilon", enumeration.cost.epsilon},
                 {"terms", std::move(terms)},
                 {"class", std::string(choiceName(enumeration.graphClass))},
                 {"method", std::string(choiceName(enumeration.method))},
                 {"count", valueOrNull(enumeration.count)},
                 {"complete", enumeration.complete}};
    if (!enumeration.part.isWhole())
        section["part"] = {{"number", enumeration.part.number}, {"of", enumeration.part.of}};
    section["subMeshes"] = std::move(subMeshes);
    return section;
}

} // namespace qm
