#include "cut/measure.h"

#include "base/at.h"

#include <cmath>

namespace qm {

Measure::Measure(const QuadMesh& mesh, const BaseComplex& complex)
    : mesh_(mesh), complex_(complex), seeds_(mesh.n_vertices(), 0), passes_(mesh.n_vertices(), 0) {
    for (const Seed seed : complex.seeds)
        ++seeds_[at(mesh.from_vertex_handle(seed.direction))];
}

VertexId Measure::sourceOf(SeparatrixId separatrix) const {
    return mesh_.from_vertex_handle(complex_.separatrices[separatrix].halfedges.front());
}

std::size_t Measure::reachInside(SeparatrixId id, const std::vector<SubMeshId>& labels) const {
    const Separatrix& separatrix = complex_.separatrices[id];
    const SubMeshId subMesh = labels[at(sourceOf(id))];
    std::size_t length = 0;
    while (length < separatrix.reach) {
        const VertexId next = mesh_.to_vertex_handle(separatrix.halfedges[length]);
        ++length;
        if (labels[at(next)] != subMesh) break;
    }
    return length;
}

SubMesh Measure::operator()(const std::vector<SeparatrixId>& separatrices,
                            const std::vector<SubMeshId>& labels, SubMeshId subMesh) {
    SubMesh result;
    std::vector<VertexId> touched;
    const auto pass = [&](VertexId vertex) {
        if (passes_[at(vertex)]++ == 0) touched.push_back(vertex);
    };
    std::vector<std::size_t> reach;
    VertexId last;
    for (const SeparatrixId id : separatrices) {
        const VertexId source = sourceOf(id);
        for (int seed = 0; source != last && seed < seeds_[at(source)]; ++seed)
            pass(source);
        last = source;
        reach.push_back(reachInside(id, labels));
        const Separatrix& separatrix = complex_.separatrices[id];
        // The part that the opposite walks inside as well is counted once only.
        std::size_t counted = 0;
        if (const auto opposite = separatrix.opposite;
            opposite && *opposite < id && labels[at(sourceOf(*opposite))] == subMesh)
            counted = reachInside(*opposite, labels);
        for (std::size_t k = 1; k < separatrix.halfedges.size() && k <= reach.back() &&
                                separatrix.halfedges.size() - k > counted;
             ++k) {
            const VertexId vertex = mesh_.from_vertex_handle(separatrix.halfedges[k]);
            if (labels[at(vertex)] == subMesh) pass(vertex);
        }
    }
    for (std::size_t n = 0; n < separatrices.size(); ++n) {
        const Separatrix& separatrix = complex_.separatrices[separatrices[n]];
        int stops = 1;
        for (std::size_t k = 1; k < reach[n]; ++k)
            if (passes_[at(mesh_.from_vertex_handle(separatrix.halfedges[k]))] == 2) ++stops;
        result.quasiComplexity += std::log2(stops);
    }
    for (const VertexId vertex : touched) {
        if (passes_[at(vertex)] == 2) ++result.ordinaryJunctions;
        passes_[at(vertex)] = 0;
    }
    return result;
}

IdVector<SubMeshId, SubMesh> measureSubMeshes(const QuadMesh& mesh, const BaseComplex& complex,
                                              const std::vector<SubMeshId>& labels, int count) {
    Measure measure(mesh, complex);
    IdVector<SubMeshId, std::vector<SeparatrixId>> separatrices(at(count));
    for (const SeparatrixId id : complex.separatrices.ids())
        separatrices[labels[at(measure.sourceOf(id))]].push_back(id);
    IdVector<SubMeshId, SubMesh> result;
    result.reserve(separatrices.size());
    for (const SubMeshId subMesh : separatrices.ids())
        result.push_back(measure(separatrices[subMesh], labels, subMesh));
    return result;
}

} // namespace qm
