#include "cut/cut.h"

#include "base/at.h"
#include "base/disjoint_sets.h"
#include "cut/coarse_geodesics.h"
#include "cut/energy.h"
#include "cut/measure.h"
#include "cut/min_cut.h"
#include "cut/terminals.h"
#include "mesh/topology.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

namespace qm {
namespace {

/// A sub-mesh while it may still be cut.
struct Piece {
    std::vector<VertexId> vertices;        ///< ascending
    std::vector<std::size_t> separatrices; ///< that start inside, ascending: so do their sources
    SubMesh measures;
};

using Pieces = std::vector<Piece>;

class Cutter {
public:
    Cutter(const QuadMesh& mesh, const BaseComplex& complex, const std::vector<double>& angles,
           const CutOptions& options, const Control& control)
        : mesh_(mesh), options_(options), control_(control), measure_(mesh, complex),
          labels_(mesh.n_vertices(), SubMeshId(0)), energy_(mesh, angles, options, labels_),
          connected_(mesh.n_vertices()), component_(mesh.n_vertices(), -1) {
        Piece whole;
        for (const VertexId vertex : mesh.vertices())
            if (!mesh.is_isolated(vertex)) whole.vertices.push_back(vertex);
        for (std::size_t i = 0; i < complex.separatrices.size(); ++i)
            whole.separatrices.push_back(i);
        remeasure(whole, SubMeshId(0));
        pending_.push_back(std::move(whole));
    }

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

    void remeasure(Piece& piece, SubMeshId label) {
        const SubMesh measured = measure_(piece.separatrices, labels_, label);
        piece.measures.quasiComplexity = measured.quasiComplexity;
        piece.measures.ordinaryJunctions = measured.ordinaryJunctions;
    }

    /// Vertices where particles of a piece start: extraordinary ones and seeds, each ascending.
    [[nodiscard]] std::pair<std::vector<VertexId>, std::vector<VertexId>>
    sourcesOf(const Piece& piece) const {
        std::vector<VertexId> extraordinary, seeds;
        VertexId last;
        for (const std::size_t i : piece.separatrices) {
            const VertexId source = measure_.sourceOf(i);
            if (source != last) (isRegular(mesh_, source) ? seeds : extraordinary).push_back(source);
            last = source;
        }
        return {std::move(extraordinary), std::move(seeds)};
    }

    /// Gives the parts of a piece labels and particles of their own.
    Pieces divide(const Piece& piece, const std::vector<int>& partOf, int count) {
        Pieces parts(at(count));
        const SubMeshId base = nextLabel_;
        nextLabel_ = base + count;
        std::vector<std::size_t> sizes(parts.size(), 0);
        for (const int part : partOf)
            ++sizes[at(part)];
        for (std::size_t part = 0; part < parts.size(); ++part)
            parts[part].vertices.reserve(sizes[part]);
        for (std::size_t k = 0; k < piece.vertices.size(); ++k) {
            labels_[at(piece.vertices[k])] = base + partOf[k];
            parts[at(partOf[k])].vertices.push_back(piece.vertices[k]);
        }
        for (const std::size_t i : piece.separatrices)
            parts[at(labels_[at(measure_.sourceOf(i))].value() - base.value())].separatrices.push_back(i);
        for (int part = 0; part < count; ++part) {
            Piece& made = parts[at(part)];
            made.measures.source = piece.measures.source;
            made.measures.sink = piece.measures.sink;
            remeasure(made, base + part);
        }
        return parts;
    }

    /// Numbers the connected components of a piece, in `component_`, by their lowest vertices. Vertices are
    /// visited in order, which is faster on large meshes than to follow edges.
    /// \return how many there are
    int numberComponents(const Piece& piece) {
        for (const VertexId vertex : piece.vertices)
            connected_.isolate(at(vertex));
        for (const VertexId vertex : piece.vertices)
            for (const VertexId next : mesh_.vv_range(vertex))
                if (next.idx() < vertex.idx() && labels_[at(next)] == labels_[at(vertex)])
                    connected_.join(at(vertex), at(next));
        int count = 0;
        for (const VertexId vertex : piece.vertices) {
            const std::size_t lowest = connected_.find(at(vertex));
            component_[at(vertex)] = lowest == at(vertex) ? count++ : component_[lowest];
        }
        return count;
    }

    /// Divides a piece into its components: each in which particles start is a part, and all the others
    /// together are one.
    /// \return nothing if the piece is connected
    Pieces separate(const Piece& piece) {
        const int components = numberComponents(piece);
        if (components < 2) return {};
        std::vector<int> partOfComponent(at(components), -1);
        int parts = 0;
        for (const std::size_t i : piece.separatrices) {
            int& part = partOfComponent[at(component_[at(measure_.sourceOf(i))])];
            if (part < 0) part = parts++;
        }
        const bool others = std::ranges::count(partOfComponent, -1) > 0;
        std::ranges::replace(partOfComponent, -1, parts);
        std::vector<int> partOf;
        for (const VertexId vertex : piece.vertices)
            partOf.push_back(partOfComponent[at(component_[at(vertex)])]);
        return divide(piece, partOf, parts + (others ? 1 : 0));
    }

    /// By sweeps over the vertices where that takes little time, else over fewer places.
    SurfaceDistances& distancesIn(const Piece& piece) {
        constexpr std::size_t maxSwept = 16000;
        if (piece.vertices.size() <= maxSwept) {
            if (!geodesics_) geodesics_.emplace(mesh_, labels_);
            return *geodesics_;
        }
        if (!coarseGeodesics_) coarseGeodesics_.emplace(mesh_, labels_);
        coarseGeodesics_->coarsen(piece.vertices);
        return *coarseGeodesics_;
    }

    /// The cut whose more complicated part is the simplest.
    /// \return nothing if that is no simpler than the whole
    Pieces cutBetween(const Piece& piece, Terminals kind) {
        const SubMeshId label = labels_[at(piece.vertices.front())];
        const auto [extraordinary, seeds] = sourcesOf(piece);
        double minComplexity = piece.measures.quasiComplexity;
        Pieces best;
        SubMeshId bestLabel;
        SurfaceDistances& distances = distancesIn(piece);
        for (const TerminalPair& terminals :
             chooseTerminals(mesh_, piece.vertices, extraordinary, seeds, kind, distances)) {
            const SubMeshId firstLabel = nextLabel_;
            Pieces parts =
                divide(piece, minimumCut(energy_(piece.vertices, extraordinary, terminals, distances)), 2);
            setLabels(piece, label);
            const double worst =
                std::max(parts[0].measures.quasiComplexity, parts[1].measures.quasiComplexity);
            if (worst >= minComplexity) continue;
            minComplexity = worst;
            for (Piece& part : parts) {
                part.measures.source = terminals.source;
                part.measures.sink = terminals.sink;
            }
            best = std::move(parts);
            bestLabel = firstLabel;
        }
        for (std::size_t part = 0; part < best.size(); ++part)
            setLabels(best[part], bestLabel + static_cast<int>(part));
        return best;
    }

    void setLabels(const Piece& piece, SubMeshId label) {
        for (const VertexId vertex : piece.vertices)
            labels_[at(vertex)] = label;
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
    Measure measure_;
    std::vector<SubMeshId> labels_;      ///< of pieces as they arise, never used twice
    std::optional<Geodesics> geodesics_; ///< made when needed
    std::optional<CoarseGeodesics> coarseGeodesics_;
    Energy energy_;
    DisjointSets connected_;     ///< vertices, in the piece at hand
    std::vector<int> component_; ///< of a vertex in the piece at hand
    Pieces pending_;
    Pieces done_;
    SubMeshId nextLabel_{1};
};

} // namespace

Cut cutMesh(const QuadMesh& mesh, const BaseComplex& complex, const std::vector<double>& dihedralAngles,
            const CutOptions& options, const Control& control) {
    if (mesh.n_vertices() == 0) return {options, {}, {}};
    return Cutter(mesh, complex, dihedralAngles, options, control).run();
}

} // namespace qm
