#include "cut/pieces.h"

#include "base/at.h"
#include "mesh/topology.h"

namespace qm {
namespace {

constexpr SubMeshId ofUndivided(0);

} // namespace

PieceDivision::PieceDivision(const QuadMesh& mesh, const BaseComplex& complex)
    : mesh_(mesh), complex_(complex), measure_(mesh, complex), labels_(mesh.n_vertices()) {}

Piece PieceDivision::whole() {
    Piece piece;
    for (const VertexId vertex : mesh_.vertices())
        if (!mesh_.is_isolated(vertex)) piece.vertices.push_back(vertex);
    for (const SeparatrixId id : complex_.separatrices.ids())
        piece.separatrices.push_back(id);
    label(piece);
    measure(piece, ofUndivided);
    unlabel(piece);
    return piece;
}

std::vector<Piece> PieceDivision::divide(const Piece& piece, const std::vector<int>& partOf, int count) {
    std::vector<Piece> parts(at(count));
    for (Piece& made : parts) {
        made.measures.source = piece.measures.source;
        made.measures.sink = piece.measures.sink;
    }
    for (std::size_t k = 0; k < piece.vertices.size(); ++k) {
        labels_[at(piece.vertices[k])] = SubMeshId(partOf[k]);
        parts[at(partOf[k])].vertices.push_back(piece.vertices[k]);
    }
    for (const SeparatrixId id : piece.separatrices)
        parts[labels_[at(sourceOf(id))].idx()].separatrices.push_back(id);
    for (std::size_t part = 0; part < parts.size(); ++part)
        measure(parts[part], SubMeshId(part));
    return parts;
}

void PieceDivision::label(const Piece& piece) {
    setLabels(piece, ofUndivided);
}

void PieceDivision::unlabel(const Piece& piece) {
    setLabels(piece, SubMeshId());
}

void PieceDivision::setLabels(const Piece& piece, SubMeshId label) {
    for (const VertexId vertex : piece.vertices)
        labels_[at(vertex)] = label;
}

PieceSources PieceDivision::sourcesOf(const Piece& piece) const {
    PieceSources sources;
    VertexId last;
    for (const SeparatrixId id : piece.separatrices) {
        const VertexId source = sourceOf(id);
        if (source != last)
            (isRegular(mesh_, source) ? sources.seeds : sources.extraordinary).push_back(source);
        last = source;
    }
    return sources;
}

void PieceDivision::measure(Piece& piece, SubMeshId label) {
    const SubMesh measured = measure_(piece.separatrices, labels_, label);
    piece.measures.quasiComplexity = measured.quasiComplexity;
    piece.measures.ordinaryJunctions = measured.ordinaryJunctions;
}

} // namespace qm
