#include "cut/cut.h"

#include "base/at.h"
#include "base/parallel.h"
#include "base/pool.h"
#include "cut/piece_cutter.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <utility>

namespace qm {
namespace {

using Pieces = std::vector<Piece>;

/// How many times pieces must be halved until the most complicated one is simple enough.
double levelsOf(const Pieces& pieces, double chi) {
    double complexity = 1;
    for (const Piece& piece : pieces)
        complexity = std::max(complexity, piece.measures.quasiComplexity);
    return std::max(1.0, std::log2(complexity / std::max(chi, 1.0)));
}

/// Numbers the sub-meshes by their lowest vertices. Isolated vertices belong to the first.
Cut cutInto(Pieces pieces, std::size_t vertices, const CutOptions& options) {
    if (pieces.size() > 1)
        std::ranges::sort(pieces, {}, [](const Piece& piece) { return piece.vertices.front().idx(); });
    Cut cut{options, std::vector<SubMeshId>(vertices, SubMeshId(0)), {}};
    for (const Piece& piece : pieces) {
        for (const VertexId vertex : piece.vertices)
            cut.labels[at(vertex)] = cut.subMeshes.nextId();
        cut.subMeshes.push_back(piece.measures);
    }
    return cut;
}

} // namespace

Cut cutMesh(const QuadMesh& mesh, const BaseComplex& complex, const std::vector<double>& dihedralAngles,
            const CutOptions& options, const Control& control) {
    if (mesh.n_vertices() == 0) return {options, {}, {}};
    Pool<PieceCutter> cutters(
        [&] { return std::make_unique<PieceCutter>(mesh, complex, dihedralAngles, options); });
    Pieces pending{cutters.use([](PieceCutter&cutter) { return cutter.whole(); })}, done;
    const double levels = levelsOf(pending, options.chi);
    while (!pending.empty()) {
        control.progress(std::max(0.0, 1 - levelsOf(pending, options.chi) / levels));
        std::vector<Pieces> parts(pending.size());
        parallelFor(pending.size(), control.jobs, [&](std::size_t k) {
            if (control.stopRequested()) return;
            parts[k] = cutters.use([&](PieceCutter& cutter) { return cutter.simplify(pending[k]); });
        });
        Pieces next;
        for (std::size_t k = 0; k < pending.size(); ++k) {
            if (parts[k].empty())
                done.push_back(std::move(pending[k]));
            else
                std::ranges::move(parts[k], std::back_inserter(next));
        }
        pending = std::move(next);
    }
    control.progress(1);
    return cutInto(std::move(done), mesh.n_vertices(), options);
}

} // namespace qm
