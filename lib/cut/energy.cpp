#include "cut/energy.h"

#include "base/at.h"
#include "mesh/topology.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace qm {
namespace {

/// Upper limit of weights, which stands for infinity but still gives finite sums.
constexpr double largestWeight = 1e100;

std::vector<double> sharpestAtVertices(const QuadMesh& mesh, const std::vector<double>& angles) {
    std::vector<double> sharpest(mesh.n_vertices(), 0);
    for (const EdgeId edge : mesh.edges())
        for (const VertexId end : endsOf(mesh, edge))
            sharpest[at(end)] = std::max(sharpest[at(end)], angles[at(edge)]);
    return sharpest;
}

} // namespace

Energy::Energy(const QuadMesh& mesh, const std::vector<double>& dihedralAngles, const CutOptions& options,
               const std::vector<SubMeshId>& labels)
    : mesh_(mesh), options_(options), labels_(labels), node_(mesh.n_vertices(), -1) {
    for (double* weight : {&options_.lambda, &options_.highPenalty, &options_.lowPenalty})
        *weight = std::min(*weight, largestWeight);
    if (options.avoidFeatures) sharpest_ = sharpestAtVertices(mesh, dihedralAngles);
}

CutProblem Energy::operator()(const std::vector<VertexId>& vertices,
                              const std::vector<VertexId>& extraordinary, const TerminalPair& terminals,
                              SurfaceDistances& distances) {
    CutProblem problem;
    for (std::size_t k = 0; k < vertices.size(); ++k)
        node_[at(vertices[k])] = static_cast<int>(k);
    // D(S, p); D(T, p) is 1 less this.
    std::vector<double> nearness = distances.between(terminals.source, vertices);
    const std::vector<double> fromSink = distances.between(terminals.sink, vertices);
    for (std::size_t k = 0; k < vertices.size(); ++k) {
        const double fromSource = nearness[k], sum = fromSource + fromSink[k];
        nearness[k] = sum > 0 && std::isfinite(sum) ? 1 - fromSource / sum : 0.5;
    }
    const auto nearnessOf = [&](VertexId vertex) -> double& { return nearness[at(node_[at(vertex)])]; };
    const auto& [sourceGroup, sinkGroup] = terminals.groups;
    if (sourceGroup.empty() && sinkGroup.empty())
        for (const VertexId vertex : extraordinary)
            nearnessOf(vertex) = nearnessOf(vertex) >= 0.5 ? 1 : 0;
    for (const VertexId vertex : sourceGroup)
        nearnessOf(vertex) = 1;
    for (const VertexId vertex : sinkGroup)
        nearnessOf(vertex) = 0;

    problem.costs.reserve(vertices.size());
    problem.edges.reserve(2 * vertices.size()); // as many as a grid has
    for (const double value : nearness)
        problem.costs.push_back({penalty(value), penalty(1 - value)});
    for (const VertexId vertex : vertices)
        for (const VertexId other : mesh_.vv_range(vertex))
            if (vertex.idx() < other.idx() && labels_[at(other)] == labels_[at(vertex)])
                problem.edges.push_back({node_[at(vertex)], node_[at(other)], capacity(vertex, other)});
    return problem;
}

/// The penalty G_p as a function of D(L, p).
double Energy::penalty(double nearness) const {
    const auto& [low, high] = std::pair(options_.lowPenalty, options_.highPenalty);
    if (nearness <= options_.nearLimit) return high;
    if (nearness > options_.farLimit) return low;
    return low + (high - low) * ((options_.farLimit - nearness) / (options_.farLimit - options_.nearLimit));
}

/// The weight of an edge of the mesh. A cut across a feature severs few edges that touch the feature; one
/// alongside it severs an edge at every step. The weight is as large as the high penalty, because a smaller
/// one would not move a cut away from where the penalties put it.
double Energy::capacity(VertexId a, VertexId b) const {
    if (sharpest_.empty()) return options_.lambda;
    const double rightAngles = std::max(sharpest_[at(a)], sharpest_[at(b)]) / (std::numbers::pi / 2);
    return options_.lambda * (1 + options_.highPenalty * rightAngles);
}

} // namespace qm
