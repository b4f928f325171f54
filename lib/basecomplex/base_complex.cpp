#include "basecomplex/base_complex.h"

#include "base/at.h"
#include "base/error.h"
#include "basecomplex/arc_graph.h"
#include "mesh/topology.h"

#include <algorithm>
#include <string>
#include <unordered_map>
#include <utility>

namespace qm {
namespace {

HalfedgeId opposite(const QuadMesh& mesh, HalfedgeId halfedge) {
    return mesh.opposite_halfedge_handle(halfedge);
}

/// The first halfedges of all separatrices, in their final order, and which halfedges arrive at a seed on its
/// own line.
struct Starts {
    std::vector<HalfedgeId> halfedges;
    std::vector<bool> arrivesAtSeed;
};

void addExtraordinary(const QuadMesh& mesh, VertexId vertex, Starts& starts) {
    for (const HalfedgeId halfedge : mesh.voh_range(vertex))
        if (!mesh.is_boundary(mesh.edge_handle(halfedge))) starts.halfedges.push_back(halfedge);
}

void addSeed(const QuadMesh& mesh, Seed seed, std::vector<bool>& seeded, Starts& starts) {
    const VertexId vertex = mesh.from_vertex_handle(seed.direction);
    const std::string place = "seed at vertex " + std::to_string(vertex.idx());
    if (!continuesStraight(mesh, vertex))
        throw Error(place, "it is not an interior regular vertex", "Choose another vertex of the curve");
    if (seeded[at(vertex)])
        throw Error(place, "another seed is there", "Choose another vertex of one of the curves");
    seeded[at(vertex)] = true;
    const HalfedgeId back = straightOn(mesh, opposite(mesh, seed.direction));
    for (const HalfedgeId halfedge : {seed.direction, back}) {
        starts.halfedges.push_back(halfedge);
        starts.arrivesAtSeed[at(opposite(mesh, halfedge))] = true;
    }
}

Starts findStarts(const QuadMesh& mesh, const std::vector<VertexId>& extraordinary,
                  std::span<const Seed> seeds) {
    Starts starts;
    starts.arrivesAtSeed.assign(mesh.n_halfedges(), false);
    for (const VertexId vertex : extraordinary)
        addExtraordinary(mesh, vertex, starts);
    std::vector<bool> seeded(mesh.n_vertices(), false);
    for (const Seed seed : seeds)
        addSeed(mesh, seed, seeded, starts);
    std::ranges::sort(starts.halfedges, {}, [&](HalfedgeId halfedge) {
        return std::pair(mesh.from_vertex_handle(halfedge).idx(), mesh.to_vertex_handle(halfedge).idx());
    });
    return starts;
}

std::vector<HalfedgeId> trace(const QuadMesh& mesh, HalfedgeId start,
                              const std::vector<bool>& arrivesAtSeed) {
    std::vector<HalfedgeId> path{start};
    while (!arrivesAtSeed[at(path.back())] && continuesStraight(mesh, mesh.to_vertex_handle(path.back())))
        path.push_back(straightOn(mesh, path.back()));
    return path;
}

void linkOpposites(const QuadMesh& mesh, std::vector<Separatrix>& separatrices) {
    std::unordered_map<int, SeparatrixId> byFirst;
    for (std::size_t i = 0; i < separatrices.size(); ++i)
        byFirst.emplace(separatrices[i].halfedges.front().idx(), SeparatrixId(i));
    for (Separatrix& separatrix : separatrices) {
        const auto found = byFirst.find(opposite(mesh, separatrix.halfedges.back()).idx());
        if (found != byFirst.end()) separatrix.opposite = found->second;
    }
}

/// The vertices visited by the present path; starting another path forgets them in constant time.
class Visits {
public:
    explicit Visits(std::size_t vertices) : lastPath_(vertices, -1) {}
    void nextPath() { ++path_; }
    /// \return whether the path has visited the vertex before
    bool visit(VertexId vertex) { return std::exchange(lastPath_[at(vertex)], path_) == path_; }

private:
    std::vector<int> lastPath_;
    int path_ = -1;
};

void measureReach(const QuadMesh& mesh, Separatrix& separatrix, Visits& visits) {
    visits.nextPath();
    visits.visit(mesh.from_vertex_handle(separatrix.halfedges.front()));
    separatrix.reach = separatrix.halfedges.size();
    // The last vertex is an end. A path that returns to its own source does not cross itself; one that
    // arrives at its own seed does.
    for (std::size_t k = 1; k < separatrix.halfedges.size(); ++k)
        if (visits.visit(mesh.from_vertex_handle(separatrix.halfedges[k]))) {
            separatrix.selfCrossing = true;
            separatrix.reach = k;
            return;
        }
}

} // namespace

BaseComplex buildBaseComplex(const QuadMesh& mesh, std::span<const Seed> seeds) {
    BaseComplex complex;
    complex.extraordinaryVertices = extraordinaryVertices(mesh);
    complex.seeds.assign(seeds.begin(), seeds.end());
    const Starts starts = findStarts(mesh, complex.extraordinaryVertices, seeds);
    complex.separatrices.reserve(starts.halfedges.size());
    for (const HalfedgeId start : starts.halfedges)
        complex.separatrices.push_back({trace(mesh, start, starts.arrivesAtSeed), std::nullopt, 0, false});
    linkOpposites(mesh, complex.separatrices);
    Visits visits(mesh.n_vertices());
    for (Separatrix& separatrix : complex.separatrices)
        measureReach(mesh, separatrix, visits);
    complex.ordinaryJunctions = buildArcGraph(mesh, complex).junctions.size();
    return complex;
}

std::vector<bool> edgesOnLines(const QuadMesh& mesh, const BaseComplex& complex) {
    std::vector<bool> onLine(mesh.n_edges());
    for (const Separatrix& separatrix : complex.separatrices)
        for (const HalfedgeId halfedge : separatrix.halfedges)
            onLine[at(mesh.edge_handle(halfedge))] = true;
    return onLine;
}

} // namespace qm
