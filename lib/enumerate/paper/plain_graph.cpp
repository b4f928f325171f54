#include "enumerate/paper/plain_graph.h"

#include "base/at.h"
#include "base/groups.h"
#include "base/id_vector.h"
#include "layout/tracks.h"

#include <algorithm>
#include <span>

namespace qm {
namespace {

/// Simulates all particles.
class Race {
public:
    Race(const QuadMesh& mesh, const BaseComplex& complex)
        : mesh_(mesh), complex_(complex), walked_(complex.separatrices.size(), 0),
          traced_(mesh.n_vertices(), false), covered_(mesh.n_edges(), false) {}

    /// \return the number of halfedges that every particle walks
    IdVector<SeparatrixId, std::size_t> run() {
        for (const VertexId vertex : complex_.extraordinaryVertices)
            traced_[at(vertex)] = true;
        for (const Seed seed : complex_.seeds)
            traced_[at(mesh_.from_vertex_handle(seed.direction))] = true;
        const auto all = walked_.ids();
        std::vector<SeparatrixId> active(all.begin(), all.end());
        while (!active.empty())
            active = meet(advance(active));
        settleMeetings();
        return walked_;
    }

private:
    struct Arrival {
        int vertex;
        SeparatrixId particle;
        // NOLINTNEXTLINE(modernize-use-nullptr): the compiler generates this 0
        auto operator<=>(const Arrival&) const = default;
    };

    [[nodiscard]] const Separatrix& separatrix(SeparatrixId id) const { return complex_.separatrices[id]; }

    /// Moves every particle over its next edge; a particle whose opposite is there already stops.
    std::vector<Arrival> advance(const std::vector<SeparatrixId>& active) {
        std::vector<Arrival> arrivals;
        for (const SeparatrixId i : active) {
            const HalfedgeId next = separatrix(i).halfedges[walked_[i]];
            const std::size_t edge = at(mesh_.edge_handle(next));
            if (covered_[edge]) continue;
            covered_[edge] = true;
            ++walked_[i];
            arrivals.push_back({mesh_.to_vertex_handle(next).idx(), i});
        }
        std::ranges::sort(arrivals);
        return arrivals;
    }

    /// Decides at every vertex which particles go on.
    std::vector<SeparatrixId> meet(const std::vector<Arrival>& arrivals) {
        std::vector<SeparatrixId> active;
        forEachGroup(arrivals, &Arrival::vertex, [&](std::span<const Arrival> here) {
            const std::size_t vertex = at(here.front().vertex);
            if (!traced_[vertex] && here.size() == 1) goOn(here[0].particle, active);
            if (!traced_[vertex] && here.size() == 2) meetTwo(here[0].particle, here[1].particle, active);
            traced_[vertex] = true;
        });
        std::ranges::sort(active);
        return active;
    }

    void goOn(SeparatrixId i, std::vector<SeparatrixId>& active) const {
        if (walked_[i] < separatrix(i).halfedges.size()) active.push_back(i);
    }

    /// The halfedge that leads back to where a particle came from.
    HalfedgeId cameFrom(SeparatrixId i) const {
        return mesh_.opposite_halfedge_handle(separatrix(i).halfedges[walked_[i] - 1]);
    }

    void meetTwo(SeparatrixId a, SeparatrixId b, std::vector<SeparatrixId>& active) const {
        const HalfedgeId fromA = cameFrom(a), fromB = cameFrom(b);
        if (mesh_.ccw_rotated_halfedge_handle(fromA) == fromB) goOn(b, active);
        if (mesh_.ccw_rotated_halfedge_handle(fromB) == fromA) goOn(a, active);
    }

    /// For every vertex, the number of its edges that some particle could walk; more than two where lines
    /// cross.
    std::vector<int> countLineEdges() const {
        std::vector<bool> counted(mesh_.n_edges(), false);
        std::vector<int> edges(mesh_.n_vertices(), 0);
        for (const Separatrix& separatrix : complex_.separatrices)
            for (std::size_t k = 0; k < separatrix.reach; ++k) {
                const HalfedgeId halfedge = separatrix.halfedges[k];
                const std::size_t edge = at(mesh_.edge_handle(halfedge));
                if (counted[edge]) continue;
                counted[edge] = true;
                ++edges[at(mesh_.from_vertex_handle(halfedge))];
                ++edges[at(mesh_.to_vertex_handle(halfedge))];
            }
        return edges;
    }

    /// Tracks must end where lines cross: after other meetings, the lower separatrix gets the rest of the
    /// arc.
    void settleMeetings() {
        const std::vector<int> lineEdges = countLineEdges();
        for (const SeparatrixId i : walked_.ids()) {
            const auto& halfedges = separatrix(i).halfedges;
            const auto opposite = separatrix(i).opposite;
            if (!opposite || *opposite < i) continue;
            std::size_t& other = walked_[*opposite];
            if (walked_[i] + other != halfedges.size()) continue;
            for (; walked_[i] > 0 && other > 0; ++walked_[i], --other)
                if (lineEdges[at(mesh_.to_vertex_handle(halfedges[walked_[i] - 1]))] > 2) break;
        }
    }

    const QuadMesh& mesh_;
    const BaseComplex& complex_;
    IdVector<SeparatrixId, std::size_t> walked_;
    std::vector<bool> traced_;  ///< of every vertex, whether a particle has been there
    std::vector<bool> covered_; ///< of every edge, likewise
};

} // namespace

MotorcycleGraph plainMotorcycleGraph(const QuadMesh& mesh, const BaseComplex& complex,
                                     const std::vector<double>& edgeCosts) {
    const IdVector<SeparatrixId, std::size_t> walked = Race(mesh, complex).run();
    MotorcycleGraph graph;
    for (const SeparatrixId i : walked.ids()) {
        if (walked[i] == 0) continue;
        const std::span path(complex.separatrices[i].halfedges);
        graph.add(trackOf(mesh, path.first(walked[i]), edgeCosts));
    }
    return graph;
}

} // namespace qm
