#include "cli/graph_line.h"

#include "document/number_text.h"

namespace qm {
namespace {

void append(std::string& text, double number) {
    char buffer[maxNumberText];
    text.append(buffer, writeNumber(buffer, number));
}

void append(std::string& text, int number) {
    char buffer[maxNumberText];
    text.append(buffer, std::to_chars(buffer, buffer + maxNumberText, number).ptr);
}

void append(std::string& text, const QuadMesh& mesh, const SeparatrixIndex& baseComplex, const Track& track) {
    const HalfedgeId first = track.halfedges.front();
    const SeparatrixId separatrix = baseComplex.startingWith(first);
    const int source = mesh.from_vertex_handle(first).idx();
    text += separatrix.valid() ? "{\"separatrix\": " : "{\"source\": ";
    append(text, separatrix.valid() ? separatrix.value() : source);
    text += ", \"vertices\": [";
    append(text, source);
    for (const HalfedgeId halfedge : track.halfedges) {
        text += ", ";
        append(text, mesh.to_vertex_handle(halfedge).idx());
    }
    text += "]}";
}

} // namespace

void appendGraphLine(const QuadMesh& mesh, const SeparatrixIndex& baseComplex, int subMesh,
                     const MotorcycleGraph& graph, std::string& text) {
    text += "{\"subMesh\": ";
    append(text, subMesh);
    text += ", \"cost\": ";
    append(text, graph.cost);
    text += ", \"tracks\": [";
    for (std::size_t k = 0; k < graph.tracks.size(); ++k) {
        if (k > 0) text += ", ";
        append(text, mesh, baseComplex, graph.tracks[k]);
    }
    text += "]}\n";
}

} // namespace qm
