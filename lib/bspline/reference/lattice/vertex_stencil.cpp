#include "bspline/reference/lattice/vertex_stencil.h"

#include "mesh/topology.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace qm {
namespace {

/// \param weights  of each neighbour along an edge and of each one across a face, for a number of edges
template <class Weights>
VertexStencil smoothStencil(const QuadMesh& mesh, VertexId vertex, const Weights& weights) {
    VertexStencil stencil;
    double edges = 0;
    for (const HalfedgeId halfedge : mesh.voh_range(vertex)) {
        ++edges;
        stencil.around.push_back({halfedge, false, 0});
        stencil.around.push_back({halfedge, true, 0});
    }
    const std::array<double, 2> weight = weights(edges);
    for (VertexStencil::Term& term : stencil.around)
        term.weight = weight[term.diagonal ? 1 : 0];
    stencil.own = 1 - edges * (weight[0] + weight[1]);
    return stencil;
}

/// Catmull and Clark's.
std::array<double, 2> subdivisionWeights(double n) {
    return {3 / (2 * n * n), 1 / (4 * n * n)};
}

std::array<double, 2> limitWeights(double n) {
    return {4 / (n * (n + 5)), 1 / (n * (n + 5))};
}

VertexStencil curveStencil(const std::array<HalfedgeId, 2>& along, double weight) {
    return {1 - 2 * weight, {{along[0], false, weight}, {along[1], false, weight}}};
}

/// By sweeps over the eigenvector's equations, with the vertex's own weight at 1 till the end; their errors
/// at least halve each time.
VertexStencil dartLimit(const QuadMesh& mesh, HalfedgeId crease) {
    constexpr int maxSweeps = 200; // halving any error 60 times leaves rounding
    // The face of each lies between it and the next.
    const std::vector<HalfedgeId> ring = leavingFrom(mesh, crease);
    const std::size_t count = ring.size();
    const double squared = static_cast<double>(count) * static_cast<double>(count);
    std::vector<double> edge(count, 4 / squared);
    std::vector<double> diagonal(count, 1 / squared);
    // The new point on the crease does not depend on the vertices beside it; that on any other edge takes a
    // sixteenth of each.
    const auto shared = [&](std::size_t k) { return k == 0 ? 0 : edge[k] / 16; };
    double change = 1;
    for (int sweep = 0; sweep < maxSweeps && change > 1e-17; ++sweep) {
        change = 0;
        for (std::size_t k = 0; k < count; ++k) {
            const std::size_t next = (k + 1) % count;
            const std::size_t previous = (k + count - 1) % count;
            diagonal[k] = (1 / (4 * squared) + shared(k) + shared(next)) / 0.75;
            const double before = edge[k];
            edge[k] = (3 / (2 * squared) + shared(previous) + shared(next) +
                       (diagonal[previous] + diagonal[k]) / 4) /
                      (k == 0 ? 0.5 : 0.625);
            change = std::max(change, std::abs(edge[k] - before));
        }
    }

    double sum = 1;
    for (std::size_t k = 0; k < count; ++k)
        sum += edge[k] + diagonal[k];
    VertexStencil stencil{1 / sum, {}};
    for (std::size_t k = 0; k < count; ++k) {
        stencil.around.push_back({ring[k], false, edge[k] / sum});
        stencil.around.push_back({ring[k], true, diagonal[k] / sum});
    }
    return stencil;
}

} // namespace

VertexStencil subdivisionStencil(const QuadMesh& mesh, VertexId vertex, const VertexRule& rule) {
    switch (rule.kind) {
    case VertexRule::Kind::crease:
        return curveStencil(rule.along, 1.0 / 8);
    case VertexRule::Kind::corner:
        return {};
    default:
        return smoothStencil(mesh, vertex, subdivisionWeights);
    }
}

VertexStencil limitStencil(const QuadMesh& mesh, VertexId vertex, const VertexRule& rule) {
    switch (rule.kind) {
    case VertexRule::Kind::crease:
        return curveStencil(rule.along, 1.0 / 6);
    case VertexRule::Kind::corner:
        return {};
    case VertexRule::Kind::dart:
        return dartLimit(mesh, rule.along[0]);
    default:
        return smoothStencil(mesh, vertex, limitWeights);
    }
}

} // namespace qm
