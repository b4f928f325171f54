#include "cli/tools/graph_line.h"

#include "base/number_text.h"

namespace qm {
namespace {

void append(std::string& text, const QuadMesh& mesh, const SeparatrixIndex& baseComplex, const Track& track) {
    const HalfedgeId first = track.halfedges.front();
    const SeparatrixId separatrix = baseComplex.startingWith(first);
    const int source = mesh.from_vertex_handle(first).idx();
    text += separatrix.valid() ? "{\"separatrix\": " : "{\"source\": ";
    appendNumber(text, separatrix.valid() ? separatrix.value() : source);
    text += ", \"vertices\": [";
    appendNumber(text, source);
    for (const HalfedgeId halfedge : track.halfedges) {
        text += ", ";
        appendNumber(text, mesh.to_vertex_handle(halfedge).idx());
    }
    text += "]}";
}

} // namespace

void appendGraphLine(const QuadMesh& mesh, const SeparatrixIndex& baseComplex, SubMeshId subMesh,
                     const MotorcycleGraph& graph, std::string& text) {
    text += "{\"subMesh\": ";
    appendNumber(text, subMesh.value());
    text += ", \"cost\": ";
    appendNumber(text, withoutSignOfZero(graph.cost));
    text += ", \"tracks\": [";
    for (std::size_t k = 0; k < graph.tracks.size(); ++k) {
        if (k > 0) text += ", ";
        append(text, mesh, baseComplex, graph.tracks[k]);
    }
    text += "]}\n";
}

} // namespace qm
