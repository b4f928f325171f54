#include "cut/cut.h"

#include "base/at.h"
#include "cut/coarse_geodesics.h"
#include "cut/energy.h"
#include "cut/label_components.h"
#include "cut/min_cut.h"
#include "cut/pieces.h"
#include "cut/terminals.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

namespace qm {
namespace {

using Pieces = std::vector<Piece>;

class Cutter {
public:
    Cutter(const QuadMesh& mesh, const BaseComplex& complex, const std::vector<double>& angles,
           const CutOptions& options, const Control& control)
        : mesh_(mesh), options_(options), control_(control), division_(mesh, complex),
          components_(mesh, division_.labels()),
          energy_(mesh, angles, options, division_.labels()), pending_{division_.whole()} {}

    Cut run() {
        while (!pending_.empty() && !control_.stopRequested()) {
            Piece piece = std::move(pending_.back());
            pending_.pop_back();
            Pieces parts = simplify(piece);
            if (parts.empty())
                done_.push_back(std::move(piece));
            else
                std::ranges::move(parts, std::back_inserter(pending_));
            control_.progress(static_cast<double>(done_.size()) /
                              static_cast<double>(done_.size() + pending_.size()));
        }
        std::ranges::move(pending_, std::back_inserter(done_));
        return finish();
    }

private:
    /// \return nothing if the piece is simple enough or gets no simpler
    Pieces simplify(const Piece& piece) {
        const double complexity = piece.measures.quasiComplexity;
        if (complexity < options_.chi || complexity == 0) return {};
        Pieces parts = separate(piece);
        if (parts.empty()) parts = cutBetween(piece, options_.terminals);
        for (const Terminals kind : {Terminals::irregular, Terminals::farthest, Terminals::box})
            if (parts.empty() && kind != options_.terminals) parts = cutBetween(piece, kind);
        return parts;
    }

    /// Divides a piece into its components: each in which particles start is a part, and all the others
    /// together are one.
    /// \return nothing if the piece is connected
    Pieces separate(const Piece& piece) {
        const int components = components_.number(piece.vertices);
        if (components < 2) return {};
        std::vector<int> partOfComponent(at(components), -1);
        int parts = 0;
        for (const std::size_t i : piece.separatrices) {
            int& part = partOfComponent[at(components_.componentOf(division_.sourceOf(i)))];
            if (part < 0) part = parts++;
        }
        const bool others = std::ranges::count(partOfComponent, -1) > 0;
        std::ranges::replace(partOfComponent, -1, parts);
        std::vector<int> partOf;
        for (const VertexId vertex : piece.vertices)
            partOf.push_back(partOfComponent[at(components_.componentOf(vertex))]);
        return division_.divide(piece, partOf, parts + (others ? 1 : 0));
    }

    /// By sweeps over the vertices where that takes little time, else over fewer places.
    SurfaceDistances& distancesIn(const Piece& piece) {
        constexpr std::size_t maxSwept = 16000;
        if (piece.vertices.size() <= maxSwept) {
            if (!geodesics_) geodesics_.emplace(mesh_, division_.labels());
            return *geodesics_;
        }
        if (!coarseGeodesics_) coarseGeodesics_.emplace(mesh_, division_.labels());
        coarseGeodesics_->coarsen(piece.vertices);
        return *coarseGeodesics_;
    }

    /// The cut whose more complicated part is the simplest.
    /// \return nothing if that is no simpler than the whole
    Pieces cutBetween(const Piece& piece, Terminals kind) {
        const PieceSources sources = division_.sourcesOf(piece);
        double minComplexity = piece.measures.quasiComplexity;
        Pieces best;
        SurfaceDistances& distances = distancesIn(piece);
        for (const TerminalPair& terminals :
             chooseTerminals(mesh_, piece.vertices, sources.extraordinary, sources.seeds, kind, distances)) {
            Pieces parts = divideBetween(piece, sources, terminals, distances);
            division_.restore(piece);
            const double worst =
                std::max(parts[0].measures.quasiComplexity, parts[1].measures.quasiComplexity);
            if (worst >= minComplexity) continue;
            minComplexity = worst;
            best = std::move(parts);
        }
        for (const Piece& part : best)
            division_.restore(part);
        return best;
    }

    Pieces divideBetween(const Piece& piece, const PieceSources& sources, const TerminalPair& terminals,
                         SurfaceDistances& distances) {
        const CutProblem problem = energy_(piece.vertices, sources.extraordinary, terminals, distances);
        Pieces parts = division_.divide(piece, minimumCut(problem), 2);
        for (Piece& part : parts) {
            part.measures.source = terminals.source;
            part.measures.sink = terminals.sink;
        }
        return parts;
    }

    /// Numbers the sub-meshes by their lowest vertices. Isolated vertices belong to the first.
    Cut finish() {
        if (done_.size() > 1)
            std::ranges::sort(done_, {}, [](const Piece& piece) { return piece.vertices.front().idx(); });
        Cut cut;
        cut.options = options_;
        cut.labels.assign(mesh_.n_vertices(), SubMeshId(0));
        for (const Piece& piece : done_) {
            for (const VertexId vertex : piece.vertices)
                cut.labels[at(vertex)] = cut.subMeshes.nextId();
            cut.subMeshes.push_back(piece.measures);
        }
        return cut;
    }

    const QuadMesh& mesh_;
    const CutOptions& options_;
    const Control& control_;
    PieceDivision division_;
    LabelComponents components_;
    std::optional<Geodesics> geodesics_; ///< made when needed
    std::optional<CoarseGeodesics> coarseGeodesics_;
    Energy energy_;
    Pieces pending_;
    Pieces done_;
};

} // namespace

Cut cutMesh(const QuadMesh& mesh, const BaseComplex& complex, const std::vector<double>& dihedralAngles,
            const CutOptions& options, const Control& control) {
    if (mesh.n_vertices() == 0) return {options, {}, {}};
    return Cutter(mesh, complex, dihedralAngles, options, control).run();
}

} // namespace qm
