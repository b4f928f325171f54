#include "cut/piece_cutter.h"

#include "base/at.h"
#include "cut/min_cut.h"

#include <algorithm>
#include <utility>

namespace qm {

PieceCutter::PieceCutter(const QuadMesh& mesh, const BaseComplex& complex,
                         const std::vector<double>& dihedralAngles, const CutOptions& options)
    : mesh_(mesh), options_(options), division_(mesh, complex), components_(mesh, division_.labels()),
      distances_(mesh, division_.labels()), energy_(mesh, dihedralAngles, options, division_.labels()) {}

std::vector<Piece> PieceCutter::simplify(const Piece& piece) {
    const double complexity = piece.measures.quasiComplexity;
    if (complexity < options_.chi || complexity == 0) return {};
    division_.label(piece);
    std::vector<Piece> parts = cut(piece);
    division_.unlabel(piece);
    return parts;
}

std::vector<Piece> PieceCutter::cut(const Piece& piece) {
    std::vector<Piece> parts = separate(piece);
    if (parts.empty()) parts = cutBetween(piece, options_.terminals);
    for (const Terminals kind : {Terminals::irregular, Terminals::farthest, Terminals::box})
        if (parts.empty() && kind != options_.terminals) parts = cutBetween(piece, kind);
    return parts;
}

/// Divides a piece into its components: each in which particles start is a part, and all the others
/// together are one.
/// \return nothing if the piece is connected
std::vector<Piece> PieceCutter::separate(const Piece& piece) {
    const int components = components_.number(piece.vertices);
    if (components < 2) return {};
    std::vector<int> partOfComponent(at(components), -1);
    int parts = 0;
    for (const SeparatrixId id : piece.separatrices) {
        int& part = partOfComponent[at(components_.componentOf(division_.sourceOf(id)))];
        if (part < 0) part = parts++;
    }
    const bool others = std::ranges::count(partOfComponent, -1) > 0;
    std::ranges::replace(partOfComponent, -1, parts);
    std::vector<int> partOf;
    for (const VertexId vertex : piece.vertices)
        partOf.push_back(partOfComponent[at(components_.componentOf(vertex))]);
    return division_.divide(piece, partOf, parts + (others ? 1 : 0));
}

/// The cut whose more complicated part is the simplest.
/// \return nothing if that is no simpler than the whole
std::vector<Piece> PieceCutter::cutBetween(const Piece& piece, Terminals kind) {
    const PieceSources sources = division_.sourcesOf(piece);
    double minComplexity = piece.measures.quasiComplexity;
    std::vector<Piece> best;
    distances_.prepare(piece.vertices);
    for (const TerminalPair& terminals : chooseTerminals(mesh_, piece.vertices, sources, kind, distances_)) {
        std::vector<Piece> parts = divideBetween(piece, sources, terminals);
        division_.label(piece);
        const double worst = std::max(parts[0].measures.quasiComplexity, parts[1].measures.quasiComplexity);
        if (worst >= minComplexity) continue;
        minComplexity = worst;
        best = std::move(parts);
    }
    return best;
}

std::vector<Piece> PieceCutter::divideBetween(const Piece& piece, const PieceSources& sources,
                                              const TerminalPair& terminals) {
    const CutProblem problem = energy_(piece.vertices, sources.extraordinary, terminals, distances_);
    std::vector<Piece> parts = division_.divide(piece, minimumCut(problem), 2);
    for (Piece& part : parts) {
        part.measures.source = terminals.source;
        part.measures.sink = terminals.sink;
    }
    return parts;
}

} // namespace qm
