#include "basecomplex/base_complex.h"

#include "base/at.h"
#include "base/error.h"
#include "base/positions.h"
#include "basecomplex/arc_graph.h"
#include "mesh/topology.h"

#include <algorithm>
#include <string>
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

using Separatrices = IdVector<SeparatrixId, Separatrix>;

void linkOpposites(const QuadMesh& mesh, Separatrices& separatrices) {
    std::vector<SeparatrixId> startingWith(mesh.n_halfedges());
    for (const SeparatrixId id : separatrices.ids())
        startingWith[at(separatrices[id].halfedges.front())] = id;
    for (Separatrix& separatrix : separatrices) {
        const SeparatrixId found = startingWith[at(opposite(mesh, separatrix.halfedges.back()))];
        if (found.valid()) separatrix.opposite = found;
    }
}

void measureReaches(const QuadMesh& mesh, Separatrices& separatrices) {
    std::vector<SeparatrixId> lastThrough(mesh.n_vertices()); // what begins at or passes a vertex
    for (const SeparatrixId id : separatrices.ids()) {
        Separatrix& separatrix = separatrices[id];
        // The last vertex is an end. A path that returns to its own source does not cross itself; one that
        // arrives at its own seed does.
        const auto crossing = std::ranges::find_if(separatrix.halfedges, [&](HalfedgeId halfedge) {
            return std::exchange(lastThrough[at(mesh.from_vertex_handle(halfedge))], id) == id;
        });
        separatrix.selfCrossing = crossing != separatrix.halfedges.end();
        separatrix.reach = positionIn(separatrix.halfedges, crossing);
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
    measureReaches(mesh, complex.separatrices);
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
