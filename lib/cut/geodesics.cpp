#include "cut/geodesics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace qm {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::size_t at(VertexId vertex) {
    return static_cast<std::size_t>(vertex.idx());
}

} // namespace

Geodesics::Geodesics(const QuadMesh& mesh, const std::vector<int>& part)
    : mesh_(mesh), part_(part), distance_(mesh.n_vertices(), infinity), lastRun_(mesh.n_vertices(), 0),
      acceptedRun_(mesh.n_vertices(), 0) {}

const std::vector<double>& Geodesics::from(VertexId source) {
    ++run_;
    const int part = part_[at(source)];
    queue_.assign(1, {0.0, source.idx()});
    distance_[at(source)] = 0;
    lastRun_[at(source)] = run_;
    while (!queue_.empty()) {
        std::ranges::pop_heap(queue_, std::greater{});
        const VertexId vertex(queue_.back().second);
        queue_.pop_back();
        if (acceptedRun_[at(vertex)] == run_) continue;
        acceptedRun_[at(vertex)] = run_;
        spread(vertex, part);
    }
    return distance_;
}

/// Improves the open vertices of all quads around a vertex whose distance has become final.
void Geodesics::spread(VertexId vertex, int part) {
    for (const HalfedgeId leaving : mesh_.voh_range(vertex)) {
        if (mesh_.is_boundary(leaving)) continue;
        std::array<VertexId, 3> others;
        HalfedgeId halfedge = leaving;
        for (VertexId& other : others) {
            other = mesh_.to_vertex_handle(halfedge);
            halfedge = mesh_.next_halfedge_handle(halfedge);
        }
        for (const VertexId target : others) {
            if (part_[at(target)] != part || acceptedRun_[at(target)] == run_) continue;
            double best = distance_[at(vertex)] + (mesh_.point(target) - mesh_.point(vertex)).norm();
            for (const VertexId other : others)
                if (other != target && acceptedRun_[at(other)] == run_)
                    best = std::min(best, across(target, vertex, other));
            if (lastRun_[at(target)] == run_ && best >= distance_[at(target)]) continue;
            lastRun_[at(target)] = run_;
            distance_[at(target)] = best;
            queue_.emplace_back(best, target.idx());
            std::ranges::push_heap(queue_, std::greater{});
        }
    }
}

/// Unfolds the triangle and the virtual source that has the known distances to a and b; infinity if the
/// straight way from it does not lead between them.
double Geodesics::across(VertexId target, VertexId a, VertexId b) const {
    const Point ab = mesh_.point(b) - mesh_.point(a), at_ = mesh_.point(target) - mesh_.point(a);
    const double length = ab.norm();
    if (length == 0) return infinity;
    const double x = (ab | at_) / length, y = std::sqrt(std::max(at_.sqrnorm() - x * x, 0.0));
    const double da = distance_[at(a)], db = distance_[at(b)];
    const double sourceX = (da * da - db * db + length * length) / (2 * length);
    const double sourceY2 = da * da - sourceX * sourceX;
    if (sourceY2 < 0) return infinity;
    const double sourceY = std::sqrt(sourceY2), height = y + sourceY;
    if (height == 0) return infinity;
    const double crossing = sourceX + (x - sourceX) * sourceY / height;
    if (crossing < 0 || crossing > length) return infinity;
    return std::hypot(x - sourceX, height);
}

} // namespace qm
