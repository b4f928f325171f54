#include "cut/geodesics.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace qm {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

} // namespace

double Geodesics::Quad::length(unsigned i, unsigned j) const {
    const unsigned ahead = (j - i) % 4;
    return ahead == 1 ? sides[i] : ahead == 3 ? sides[j] : diagonals[i % 2];
}

Geodesics::Geodesics(const QuadMesh& mesh, const std::vector<int>& part)
    : part_(part), firstCorner_(mesh.n_vertices() + 1, 0), distance_(mesh.n_vertices(), infinity),
      final_(mesh.n_vertices(), 0) {
    quads_.reserve(mesh.n_faces());
    for (const FaceId face : mesh.faces()) {
        Quad quad{};
        unsigned k = 0;
        for (const VertexId vertex : mesh.fv_range(face)) {
            quad.corners[k++] = vertex.idx();
            ++firstCorner_[at(vertex.idx()) + 1];
        }
        const auto distance = [&](unsigned i, unsigned j) {
            return (mesh.point(VertexId(quad.corners[i])) - mesh.point(VertexId(quad.corners[j]))).norm();
        };
        for (k = 0; k < 4; ++k)
            quad.sides[k] = distance(k, (k + 1) % 4);
        quad.diagonals = {distance(0, 2), distance(1, 3)};
        quads_.push_back(quad);
    }
    for (std::size_t v = 1; v < firstCorner_.size(); ++v)
        firstCorner_[v] += firstCorner_[v - 1];
    cornersAround_.resize(firstCorner_.back());
    std::vector<std::uint32_t> next(firstCorner_.begin(), firstCorner_.end() - 1);
    for (std::uint32_t quad = 0; quad < quads_.size(); ++quad)
        for (std::uint32_t k = 0; k < 4; ++k)
            cornersAround_[next[at(quads_[quad].corners[k])]++] = 4 * quad + k;
}

const std::vector<double>& Geodesics::from(VertexId source) {
    forget();
    distance_[at(source.idx())] = 0;
    touched_.push_back(source.idx());
    queue_.assign(1, {0.0, source.idx()});
    while (!queue_.empty()) {
        std::ranges::pop_heap(queue_, std::greater{});
        const int vertex = queue_.back().second;
        queue_.pop_back();
        if (final(vertex)) continue;
        final_[at(vertex)] = 1;
        spread(vertex, part_[at(source.idx())]);
    }
    return distance_;
}

void Geodesics::forget() {
    for (const int vertex : touched_) {
        distance_[at(vertex)] = infinity;
        final_[at(vertex)] = 0;
    }
    touched_.clear();
}

/// Improves the open vertices of all quads around a vertex whose distance has become final.
void Geodesics::spread(int vertex, int part) {
    for (std::uint32_t k = firstCorner_[at(vertex)]; k < firstCorner_[at(vertex) + 1]; ++k) {
        const Quad& quad = quads_[cornersAround_[k] / 4];
        const unsigned from = cornersAround_[k] % 4;
        for (unsigned ahead = 1; ahead < 4; ++ahead) {
            const unsigned to = (from + ahead) % 4;
            if (part_[at(quad.corners[to])] == part && !final(quad.corners[to])) reach(quad, from, to);
        }
    }
}

void Geodesics::reach(const Quad& quad, unsigned from, unsigned to) {
    const int target = quad.corners[to];
    double best = distance_[at(quad.corners[from])] + quad.length(from, to);
    for (unsigned other = 0; other < 4; ++other)
        if (other != from && other != to && final(quad.corners[other]))
            best = std::min(best, across(quad, from, other, to));
    double& distance = distance_[at(target)];
    if (!(best < distance)) return;
    if (distance == infinity) touched_.push_back(target);
    distance = best;
    queue_.emplace_back(best, target);
    std::ranges::push_heap(queue_, std::greater{});
}

/// Unfolds the triangle and the virtual source that has the known distances to a and b, with a at the origin
/// and b on the x axis; infinity if the straight way from that source does not lead between them.
double Geodesics::across(const Quad& quad, unsigned a, unsigned b, unsigned target) const {
    const double length = quad.length(a, b), toA = quad.length(a, target), toB = quad.length(b, target);
    if (length == 0) return infinity;
    const double x = (toA * toA - toB * toB + length * length) / (2 * length);
    const double y = std::sqrt(std::max(toA * toA - x * x, 0.0));
    const double fromA = distance_[at(quad.corners[a])], fromB = distance_[at(quad.corners[b])];
    const double sourceX = (fromA * fromA - fromB * fromB + length * length) / (2 * length);
    const double sourceSquare = fromA * fromA - sourceX * sourceX;
    if (sourceSquare < 0) return infinity;
    const double sourceY = std::sqrt(sourceSquare), height = y + sourceY;
    const double crossing = sourceX * y + x * sourceY; // times the height
    if (height == 0 || crossing < 0 || crossing > length * height) return infinity;
    return std::sqrt((x - sourceX) * (x - sourceX) + height * height);
}

} // namespace qm
