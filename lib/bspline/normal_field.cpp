#include "bspline/normal_field.h"

#include <cmath>

namespace qm {

NormalField::NormalField(const QuadMesh& mesh, const Chains& chains, const LineDerivatives& lines)
    : mesh_(mesh), chains_(chains), lines_(lines), corners_(mesh, chains, lines),
      tJoints_(mesh.n_vertices(), false) {
    findTJoints();
    setEdges();
}

void NormalField::findTJoints() {
    std::vector<std::array<int, 2>> counts(mesh_.n_vertices(), {0, 0}); // of passing and of ending chains
    const auto note = [&](HalfedgeId leaving, bool passes) {
        ++counts[static_cast<std::size_t>(mesh_.from_vertex_handle(leaving).idx())][passes ? 0 : 1];
    };
    for (const BorderChain& chain : chains_.all()) {
        for (std::size_t k = 0; k < chain.halfedges.size(); ++k)
            note(chain.halfedges[k], k > 0);
        note(mesh_.opposite_halfedge_handle(chain.halfedges.back()), false);
    }
    for (std::size_t k = 0; k < tJoints_.size(); ++k)
        tJoints_[k] = counts[k] == std::array<int, 2>{1, 1};
}

void NormalField::setCurves(const std::vector<SplineCurve>& curves) {
    corners_.setCurves(curves);
    setEdges();
}

void NormalField::setEdges() {
    edges_.clear();
    for (const BorderChain& chain : chains_.all()) {
        std::vector<OnEdge> edges;
        for (const HalfedgeId halfedge : chain.halfedges) {
            OnEdge edge;
            edge.smooth = lines_.isSmoothInside(mesh_.edge_handle(halfedge));
            if (edge.smooth)
                edge.normal = {corners_.onLeft(halfedge),
                               corners_.onLeft(mesh_.opposite_halfedge_handle(halfedge))};
            edge.smooth = edge.smooth && edge.normal[0].sqrnorm() > 0 && edge.normal[1].sqrnorm() > 0;
            edge.slope.fill(edge.normal[1] - edge.normal[0]);
            edges.push_back(edge);
        }
        for (std::size_t k = 1; k < edges.size(); ++k) {
            constexpr double rounding = 1e-6;
            if (!edges[k - 1].smooth || !edges[k].smooth ||
                (edges[k - 1].normal[1] - edges[k].normal[0]).norm() > rounding)
                continue;
            const Point slope = (edges[k].normal[1] - edges[k - 1].normal[0]) / 2.0;
            edges[k - 1].slope[1] = slope;
            edges[k].slope[0] = slope;
        }
        edges_.push_back(std::move(edges));
    }
}

Point NormalField::at(const ChainPlace& place, double share) const {
    const auto& edges = edges_[place.chain];
    const auto position = static_cast<std::size_t>(place.position);
    const OnEdge& edge = place.way == 0 ? edges[position] : edges[edges.size() - 1 - position];
    if (!edge.smooth) return {0, 0, 0};
    const double t = place.way == 0 ? share : 1 - share;
    const double s = 1 - t;
    const Point normal = s * s * (1 + 2 * t) * edge.normal[0] + t * t * (1 + 2 * s) * edge.normal[1] +
                         s * s * t * edge.slope[0] - t * t * s * edge.slope[1];
    const double length = normal.norm();
    return length > 0 ? Point(normal / length) : Point(0, 0, 0);
}

std::vector<Point> NormalField::tangentPlanes(HalfedgeId halfedge) const {
    constexpr double distinct = 0.2; // sine of the angle between planes that meet in a ridge
    constexpr double near = 0.7;     // sine of the largest angle by which an edge is turned
    const HalfedgeId opposite = mesh_.opposite_halfedge_handle(halfedge);
    const Point step =
        mesh_.point(mesh_.to_vertex_handle(halfedge)) - mesh_.point(mesh_.from_vertex_handle(halfedge));
    const double length = step.norm();
    if (!(length > 0)) return {};
    std::vector<Point> normals;
    if (!mesh_.is_boundary(halfedge)) normals.push_back(corners_.onLeft(halfedge));
    if (!mesh_.is_boundary(opposite) && (normals.empty() || !lines_.isSmooth(mesh_.edge_handle(halfedge))))
        normals.push_back(corners_.onLeft(mesh_.next_halfedge_handle(opposite)));
    std::erase_if(normals, [](const Point& normal) { return normal.sqrnorm() == 0; });
    if (normals.size() == 2) {
        const Point ridge = normals[0] % normals[1];
        if (ridge.norm() > distinct)
            return (step % ridge).norm() < near * length * ridge.norm() ? normals : std::vector<Point>();
        normals = {normals[0] + normals[1]};
        normals[0] /= normals[0].norm();
    }
    std::erase_if(normals, [&](const Point& normal) { return std::abs(step | normal) > near * length; });
    return normals;
}

} // namespace qm
