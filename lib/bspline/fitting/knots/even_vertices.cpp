#include "bspline/fitting/knots/even_vertices.h"

#include "base/at.h"
#include "bspline/splines/evaluate.h"
#include "mesh/topology.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>

namespace qm {
namespace {

/// The place nearest to the vertex at which the reference is looked at, in mesh edges.
constexpr double nearest = 1.0 / 16;

/// The shortest reach that is tried, even where a longer one is too long already.
constexpr double minReach = 1.0 / 8;

/// The distances at which reaches may end, and at which the reference is looked at: after this it doubles up
/// to one mesh edge, and grows by one edge from there on.
double nextDistance(double distance) {
    return distance < 1 ? 2 * distance : distance + 1;
}

/// The normals of reference and vertex are taken to form no larger angle than this cosine tells.
constexpr double minCosine = 0.2;

/// The ends of tangent ratios, by the halfedge that leaves the vertex there.
std::map<HalfedgeId, RunEnd> endsOfRatios(const QuadMesh& mesh, const SmoothNetwork& network) {
    std::map<HalfedgeId, RunEnd> ends;
    for (std::size_t k = 0; k < network.runs.size(); ++k) {
        const SmoothRun& run = network.runs[k];
        const auto& halfedges = network.stretches[run.stretch].halfedges;
        if (run.ratio.atEnd[0] != 0) ends[halfedges[at(run.begin)]] = {k, 0};
        if (run.ratio.atEnd[1] != 0) ends[mesh.opposite_halfedge_handle(halfedges[at(run.end - 1)])] = {k, 1};
    }
    return ends;
}

/// The borders around a vertex, without places.
EvenVertex bordersAround(const QuadMesh& mesh, const SmoothNetwork& network,
                         const std::map<HalfedgeId, RunEnd>& ends, HalfedgeId first) {
    EvenVertex result;
    double sign = 1;
    for (const HalfedgeId leaving : leavingFrom(mesh, first)) {
        if (const auto found = ends.find(leaving); found != ends.end()) {
            const auto [run, end] = found->second;
            const double ratio = network.runs[run].ratio.atEnd[end];
            // At its end the run comes to the vertex.
            result.borders.push_back({found->second, end == 0 ? sign * ratio : -sign * ratio, {}});
        }
        sign = -sign;
    }
    return result;
}

SurfacePoint onBorder(const ReferenceGrid& grid, const StretchSide& place, double x) {
    const auto [u, v] = patchPlace(grid.size, place, x);
    return grid.evaluate(u, v);
}

void addPlaces(const SmoothNetwork& network, const std::vector<ReferenceGrid>& grids, EvenVertex& vertex) {
    const auto evaluate = [&](const RunEnd& end, std::size_t side, double distance) {
        const SmoothRun& run = network.runs[end.run];
        const StretchSide& place = network.stretches[run.stretch].sides[side];
        return onBorder(grids[place.patch], place, run.parameterAt(end.end, distance));
    };
    Point normal(0, 0, 0);
    for (const EvenBorder& border : vertex.borders)
        for (const std::size_t side : {0U, 1U})
            normal += evaluate(border.end, side, 0).normal();
    normal.normalize_cond();
    for (EvenBorder& border : vertex.borders) {
        const Point origin = evaluate(border.end, 0, 0).position;
        const double length = network.runs[border.end.run].ratio.length;
        double distance = nearest;
        while (distance <= length) {
            const SurfacePoint point = evaluate(border.end, 0, distance);
            border.places.push_back({distance, normal | (point.position - origin),
                                     std::clamp(normal | point.normal(), minCosine, 1.0)});
            distance = nextDistance(distance);
        }
    }
}

/// Between places the height divided by the square of the distance is interpolated.
EvenBorder::Place placeAt(const EvenBorder& border, double distance) {
    const auto& places = border.places;
    auto after = std::ranges::lower_bound(places, distance, {}, &EvenBorder::Place::distance);
    if (after == places.end()) --after;
    const EvenBorder::Place& b = *after;
    const EvenBorder::Place& a = after == places.begin() ? b : *(after - 1);
    const double share = b.distance > a.distance ? (distance - a.distance) / (b.distance - a.distance) : 0;
    const auto bend = [](const EvenBorder::Place& place) {
        return place.height / (place.distance * place.distance);
    };
    return {distance, std::lerp(bend(a), bend(b), share) * distance * distance,
            std::lerp(a.cosine, b.cosine, share)};
}

std::vector<double> limited(std::vector<double> reaches, double limit) {
    for (double& reach : reaches)
        reach = std::min(reach, limit);
    return reaches;
}

} // namespace

std::vector<EvenVertex> evenVertices(const QuadMesh& mesh, const SmoothNetwork& network,
                                     const std::vector<ReferenceGrid>& grids) {
    const auto ends = endsOfRatios(mesh, network);
    std::vector<EvenVertex> result;
    std::vector<bool> isDone(mesh.n_vertices());
    for (const auto& [halfedge, unused] : ends) {
        const VertexId vertex = mesh.from_vertex_handle(halfedge);
        if (isDone[at(vertex)]) continue;
        isDone[at(vertex)] = true;
        if (network.rules[at(vertex)].kind != VertexRule::Kind::smooth || mesh.valence(vertex) % 2 != 0)
            continue;
        result.push_back(bordersAround(mesh, network, ends, halfedge));
        addPlaces(network, grids, result.back());
    }
    return result;
}

std::vector<double> reachesAt(const EvenVertex& vertex, const KnotPlan& plan) {
    std::vector<double> reaches;
    for (const EvenBorder& border : vertex.borders) {
        const TangentRatio& ratio = plan.runs()[border.end.run].ratio;
        reaches.push_back(ratio.isLinear ? ratio.length / 2 : ratio.reach[border.end.end]);
    }
    return reaches;
}

double minError(const EvenVertex& vertex, const std::vector<double>& reaches) {
    double sum = 0;
    double perError = 0; // how much the sum changes if all borders are off by 1
    for (std::size_t k = 0; k < reaches.size(); ++k) {
        const EvenBorder::Place place = placeAt(vertex.borders[k], reaches[k]);
        const double weight = vertex.borders[k].ratio / (reaches[k] * reaches[k]);
        sum += weight * place.height;
        perError += std::abs(weight) / place.cosine;
    }
    return perError > 0 ? std::abs(sum) / perError : 0;
}

void shortenAtEvenVertices(const std::vector<EvenVertex>& vertices, double allowed, KnotPlan& plan) {
    for (const EvenVertex& vertex : vertices) {
        const std::vector<double> before = reachesAt(vertex, plan);
        if (before.empty() || minError(vertex, before) <= allowed) continue;
        double common = minReach;
        const double longest = std::ranges::max(before);
        while (nextDistance(common) < longest &&
               minError(vertex, limited(before, nextDistance(common))) <= allowed)
            common = nextDistance(common);
        for (std::size_t k = 0; k < before.size(); ++k)
            if (before[k] > common) plan.limitReach(vertex.borders[k].end, common);
    }
}

} // namespace qm
