#include "cut/cut.h"

#include "cut/measure.h"
#include "cut/min_cut.h"
#include "cut/terminals.h"
#include "mesh/topology.h"

#include <algorithm>
#include <array>

namespace qm {
namespace {

std::size_t at(VertexId vertex) {
    return static_cast<std::size_t>(vertex.idx());
}

/// A sub-mesh while it may still be cut.
struct Piece {
    std::vector<VertexId> vertices; ///< ascending
    std::vector<std::size_t> separatrices;
    SubMesh measures;
};

class Cutter {
public:
    Cutter(const QuadMesh& mesh, const BaseComplex& complex, const std::vector<double>& angles,
           const CutOptions& options, const Control& control)
        : mesh_(mesh), angles_(angles), options_(options), control_(control), measure_(mesh, complex),
          labels_(mesh.n_vertices(), 0), geodesics_(mesh, labels_), index_(mesh.n_vertices(), -1) {
        Piece whole;
        for (const VertexId vertex : mesh.vertices())
            whole.vertices.push_back(vertex);
        for (std::size_t i = 0; i < complex.separatrices.size(); ++i)
            whole.separatrices.push_back(i);
        remeasure(whole, 0);
        pending_.push_back(std::move(whole));
    }

    Cut run() {
        while (!pending_.empty() && !control_.stopRequested()) {
            Piece piece = std::move(pending_.back());
            pending_.pop_back();
            std::vector<Piece> parts;
            if (piece.measures.quasiComplexity >= options_.chi) {
                parts = separate(piece);
                if (parts.size() < 2) parts = bestCut(piece);
            }
            if (parts.size() < 2)
                done_.push_back(std::move(piece));
            else
                for (Piece& part : parts)
                    pending_.push_back(std::move(part));
            control_.progress(static_cast<double>(done_.size()) /
                              static_cast<double>(done_.size() + pending_.size()));
        }
        std::ranges::move(pending_, std::back_inserter(done_));
        return finish();
    }

private:
    void remeasure(Piece& piece, int label) {
        const SubMesh measured = measure_(piece.separatrices, labels_, label);
        piece.measures.quasiComplexity = measured.quasiComplexity;
        piece.measures.ordinaryJunctions = measured.ordinaryJunctions;
    }

    [[nodiscard]] std::vector<VertexId> sourcesOf(const Piece& piece) const {
        std::vector<VertexId> sources;
        for (const std::size_t i : piece.separatrices)
            if (sources.empty() || sources.back() != measure_.sourceOf(i))
                sources.push_back(measure_.sourceOf(i));
        return sources;
    }

    /// Gives the parts of a piece labels and particles of their own.
    std::vector<Piece> divide(const Piece& piece, const std::vector<int>& partOf, int parts) {
        std::vector<Piece> result(static_cast<std::size_t>(parts));
        const int base = nextLabel_;
        nextLabel_ += parts;
        for (std::size_t k = 0; k < piece.vertices.size(); ++k) {
            labels_[at(piece.vertices[k])] = base + partOf[k];
            result[static_cast<std::size_t>(partOf[k])].vertices.push_back(piece.vertices[k]);
        }
        for (const std::size_t i : piece.separatrices)
            result[static_cast<std::size_t>(labels_[at(measure_.sourceOf(i))] - base)].separatrices.push_back(
                i);
        for (int part = 0; part < parts; ++part) {
            result[static_cast<std::size_t>(part)].measures.source = piece.measures.source;
            result[static_cast<std::size_t>(part)].measures.sink = piece.measures.sink;
            remeasure(result[static_cast<std::size_t>(part)], base + part);
        }
        return result;
    }

    /// What does not hang together is separate already. Isolated vertices stay with the first part.
    std::vector<Piece> separate(const Piece& piece) {
        std::vector<int> partOf(piece.vertices.size(), -1);
        number(piece);
        int parts = 0;
        std::vector<std::size_t> pending;
        for (std::size_t start = 0; start < partOf.size(); ++start) {
            if (partOf[start] >= 0 || mesh_.is_isolated(piece.vertices[start])) continue;
            partOf[start] = parts;
            pending.assign(1, start);
            while (!pending.empty()) {
                const VertexId vertex = piece.vertices[pending.back()];
                pending.pop_back();
                for (const VertexId neighbour : mesh_.vv_range(vertex)) {
                    if (labels_[at(neighbour)] != labels_[at(vertex)]) continue;
                    const auto k = static_cast<std::size_t>(index_[at(neighbour)]);
                    if (partOf[k] >= 0) continue;
                    partOf[k] = parts;
                    pending.push_back(k);
                }
            }
            ++parts;
        }
        std::ranges::replace(partOf, -1, 0);
        return parts < 2 ? std::vector<Piece>{} : divide(piece, partOf, parts);
    }

    void number(const Piece& piece) {
        for (std::size_t k = 0; k < piece.vertices.size(); ++k)
            index_[at(piece.vertices[k])] = static_cast<int>(k);
    }

    /// The cut that leaves its more complicated part least complicated; none if that is no simpler than the
    /// whole.
    std::vector<Piece> bestCut(const Piece& piece) {
        std::vector<Piece> best;
        std::vector<int> bestSides;
        const auto worst = [](const std::vector<Piece>& parts) {
            return std::max(parts[0].measures.quasiComplexity, parts[1].measures.quasiComplexity);
        };
        const int label = labels_[at(piece.vertices.front())];
        for (const TerminalPair& pair :
             chooseTerminals(mesh_, piece.vertices, sourcesOf(piece), options_.terminals, geodesics_)) {
            const std::vector<int> sides = cutBetween(piece, pair);
            const auto sinks = static_cast<std::size_t>(std::ranges::count(sides, 1));
            if (sinks == 0 || sinks == sides.size()) continue;
            std::vector<Piece> parts = divide(piece, sides, 2);
            if (worst(parts) < piece.measures.quasiComplexity &&
                (best.empty() || worst(parts) < worst(best))) {
                for (Piece& part : parts) {
                    part.measures.source = pair.source;
                    part.measures.sink = pair.sink;
                }
                best = std::move(parts);
                bestSides = sides;
            }
            for (const VertexId vertex : piece.vertices)
                labels_[at(vertex)] = label;
        }
        if (best.empty()) return best;
        const int base = nextLabel_;
        nextLabel_ += 2;
        for (std::size_t k = 0; k < piece.vertices.size(); ++k)
            labels_[at(piece.vertices[k])] = base + bestSides[k];
        return best;
    }

    std::vector<int> cutBetween(const Piece& piece, const TerminalPair& pair) {
        CutProblem problem;
        problem.costs = nodeCosts(piece, pair);
        number(piece);
        for (const VertexId vertex : piece.vertices)
            for (const HalfedgeId halfedge : mesh_.voh_range(vertex)) {
                const VertexId other = mesh_.to_vertex_handle(halfedge);
                if (other.idx() < vertex.idx() || labels_[at(other)] != labels_[at(vertex)]) continue;
                problem.edges.push_back({index_[at(vertex)], index_[at(other)], capacity(halfedge)});
            }
        return minimumCut(problem);
    }

    std::vector<std::array<double, 2>> nodeCosts(const Piece& piece, const TerminalPair& pair) {
        const std::vector<double> fromSource = geodesics_.from(pair.source);
        const std::vector<double> fromSink = geodesics_.from(pair.sink);
        const std::vector<double> group1 =
            pair.groupSource == pair.source ? fromSource : geodesics_.from(pair.groupSource);
        const std::vector<double> group2 =
            pair.groupSink == pair.sink ? fromSink : geodesics_.from(pair.groupSink);
        std::vector<bool> isSource(piece.vertices.size(), false);
        number(piece);
        for (const VertexId source : sourcesOf(piece))
            isSource[static_cast<std::size_t>(index_[at(source)])] = true;
        std::vector<std::array<double, 2>> costs;
        for (std::size_t k = 0; k < piece.vertices.size(); ++k) {
            const std::size_t v = at(piece.vertices[k]);
            const double sum = fromSource[v] + fromSink[v];
            double nearness = sum > 0 ? 1 - fromSource[v] / sum : 0.5; // D(S, p); D(T, p) is the rest
            if (isSource[k]) nearness = group1[v] <= group2[v] ? 1 : 0;
            costs.push_back({penalty(nearness), penalty(1 - nearness)});
        }
        return costs;
    }

    /// G_p.
    [[nodiscard]] double penalty(double nearness) const {
        if (nearness <= options_.nearLimit) return options_.highPenalty;
        if (nearness > options_.farLimit) return options_.lowPenalty;
        const double slope =
            (options_.highPenalty - options_.lowPenalty) / (options_.farLimit - options_.nearLimit);
        return options_.lowPenalty + slope * (options_.farLimit - nearness);
    }

    [[nodiscard]] double capacity(HalfedgeId halfedge) const {
        if (!options_.avoidFeatures) return options_.lambda;
        double sharpest = 0;
        for (const VertexId end : {mesh_.from_vertex_handle(halfedge), mesh_.to_vertex_handle(halfedge)})
            for (const EdgeId edge : mesh_.ve_range(end))
                sharpest = std::max(sharpest, angles_[static_cast<std::size_t>(edge.idx())]);
        return options_.lambda * (1 + sharpest);
    }

    Cut finish() {
        std::ranges::sort(done_, {}, [](const Piece& piece) { return piece.vertices.front().idx(); });
        Cut cut;
        cut.options = options_;
        cut.labels.resize(mesh_.n_vertices());
        for (std::size_t k = 0; k < done_.size(); ++k) {
            for (const VertexId vertex : done_[k].vertices)
                cut.labels[at(vertex)] = static_cast<int>(k);
            cut.subMeshes.push_back(done_[k].measures);
        }
        return cut;
    }

    const QuadMesh& mesh_;
    const std::vector<double>& angles_;
    const CutOptions& options_;
    const Control& control_;
    Measure measure_;
    std::vector<int> labels_; ///< of pieces as they arise, never used twice
    Geodesics geodesics_;
    std::vector<int> index_; ///< of a vertex in the piece at hand
    std::vector<Piece> pending_;
    std::vector<Piece> done_;
    int nextLabel_ = 1;
};

} // namespace

Cut cutMesh(const QuadMesh& mesh, const BaseComplex& complex, const std::vector<double>& dihedralAngles,
            const CutOptions& options, const Control& control) {
    if (mesh.n_vertices() == 0) return {options, {}, {}};
    return Cutter(mesh, complex, dihedralAngles, options, control).run();
}

} // namespace qm
