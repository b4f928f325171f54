#include "cut/geodesics.h"

#include "base/at.h"
#include "base/infinity.h"
#include "mesh/bounding_box.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace qm {
namespace {

/// The usual difference of distance between the two ends of an edge.
double stepOf(const std::vector<Point>& points, const std::vector<std::array<int, 4>>& quads) {
    double sum = 0;
    for (const auto& quad : quads)
        for (unsigned k = 0; k < 4; ++k)
            sum += (points[at(quad[k])] - points[at(quad[(k + 1) % 4])]).norm();
    return quads.empty() ? 0 : sum / (16 * static_cast<double>(quads.size()));
}

/// Morton's curve through the bounding box of a set of points.
class SpaceCurve {
public:
    explicit SpaceCurve(const std::vector<Point>& points) {
        const BoundingBox box = boundingBoxOf(points);
        low_ = box.low;
        if (const double size = box.size().max(); size > 0) cellsPerLength_ = (cells - 1) / size;
    }

    [[nodiscard]] std::uint64_t place(const Point& point) const {
        std::uint64_t result = 0;
        for (unsigned axis = 0; axis < 3; ++axis) {
            const auto cell = static_cast<std::uint64_t>((point[axis] - low_[axis]) * cellsPerLength_);
            for (unsigned bit = 0; bit < bits; ++bit)
                result |= (cell >> bit & 1U) << (3 * bit + axis);
        }
        return result;
    }

private:
    static constexpr unsigned bits = 16;
    static constexpr double cells = 1U << bits;
    Point low_;
    double cellsPerLength_ = 0;
};

} // namespace

double Geodesics::Quad::length(unsigned i, unsigned j) const {
    const unsigned ahead = (j - i) % 4;
    return ahead == 1 ? sides[i] : ahead == 3 ? sides[j] : diagonals[i % 2];
}

Geodesics::Geodesics(const std::vector<Point>& points, const std::vector<std::array<int, 4>>& quads)
    : nodeOf_(numberNodes(points)), firstCorner_(points.size() + 1, 0), distance_(points.size(), infinity),
      front_(stepOf(points, quads)) {
    quads_.reserve(quads.size());
    for (const auto& corners : quads) {
        Quad quad{};
        const auto length = [&](unsigned i, unsigned j) {
            return (points[at(corners[i])] - points[at(corners[j])]).norm();
        };
        for (unsigned k = 0; k < 4; ++k) {
            quad.corners[k] = nodeOf_[at(corners[k])];
            ++firstCorner_[at(quad.corners[k]) + 1];
            quad.sides[k] = length(k, (k + 1) % 4);
        }
        quad.diagonals = {length(0, 2), length(1, 3)};
        quads_.push_back(quad);
    }
    std::ranges::sort(quads_, {}, [](const Quad& quad) { return quad.corners; });
    for (std::size_t v = 1; v < firstCorner_.size(); ++v)
        firstCorner_[v] += firstCorner_[v - 1];
    cornersAround_.resize(firstCorner_.back());
    std::vector<std::uint32_t> next(firstCorner_.begin(), firstCorner_.end() - 1);
    for (std::uint32_t quad = 0; quad < quads_.size(); ++quad)
        for (std::uint32_t k = 0; k < 4; ++k)
            cornersAround_[next[at(quads_[quad].corners[k])]++] = 4 * quad + k;
}

/// Numbers the vertices along a space-filling curve, so that neighbours are close in memory.
std::vector<int> Geodesics::numberNodes(const std::vector<Point>& points) {
    std::vector<std::pair<std::uint64_t, int>> places;
    places.reserve(points.size());
    const SpaceCurve curve(points);
    for (std::size_t k = 0; k < points.size(); ++k)
        places.emplace_back(curve.place(points[k]), static_cast<int>(k));
    std::ranges::sort(places);
    std::vector<int> nodeOf(places.size());
    nodes_.reserve(places.size());
    for (const auto& [place, vertex] : places) {
        nodeOf[at(vertex)] = static_cast<int>(nodes_.size());
        nodes_.push_back({infinity, vertex, false, false});
    }
    return nodeOf;
}

const std::vector<double>& Geodesics::from(std::span<const Start> starts) {
    forget();
    for (const Start& start : starts) {
        const int node = nodeOf_[at(start.vertex)];
        nodeAt(node).distance = start.distance;
        touched_.push_back(node);
        front_.push({start.distance, start.vertex, node});
    }
    while (!front_.empty()) {
        const int reached = front_.pop().node;
        Node& node = nodeAt(reached);
        if (node.final) continue;
        node.final = true;
        distance_[at(node.vertex)] = node.distance;
        spread(reached);
    }
    return distance_;
}

void Geodesics::forget() {
    for (const int touched : touched_) {
        Node& node = nodeAt(touched);
        node.distance = distance_[at(node.vertex)] = infinity;
        node.final = false;
    }
    touched_.clear();
}

/// Updates the open vertices of all quads around a vertex whose distance has become final.
void Geodesics::spread(int node) {
    for (std::uint32_t k = firstCorner_[at(node)]; k < firstCorner_[at(node) + 1]; ++k) {
        const Quad& quad = quads_[cornersAround_[k] / 4];
        const unsigned from = cornersAround_[k] % 4;
        for (unsigned ahead = 1; ahead < 4; ++ahead) {
            const unsigned to = (from + ahead) % 4;
            if (!nodeAt(quad.corners[to]).final) reach(quad, from, to);
        }
    }
    for (const int improved : improved_) {
        Node& nearer = nodeAt(improved);
        nearer.improved = false;
        front_.push({nearer.distance, nearer.vertex, improved});
    }
    improved_.clear();
}

void Geodesics::reach(const Quad& quad, unsigned from, unsigned to) {
    Node& target = nodeAt(quad.corners[to]);
    double best = std::min(target.distance, nodeAt(quad.corners[from]).distance + quad.length(from, to));
    for (unsigned other = 0; other < 4; ++other)
        if (other != from && other != to && nodeAt(quad.corners[other]).final)
            best = std::min(best, across(quad, from, other, to, best));
    if (!(best < target.distance)) return;
    if (target.distance == infinity) touched_.push_back(quad.corners[to]);
    if (!target.improved) improved_.push_back(quad.corners[to]);
    target.improved = true;
    target.distance = best;
}

/// The distance of the target across a triangle. Unfolds the triangle with a at the origin and b on the x
/// axis, and finds the virtual source with the known distances to a and b. Infinity if the straight line from
/// there does not pass between a and b, or is no shorter than the limit.
double Geodesics::across(const Quad& quad, unsigned a, unsigned b, unsigned target, double limit) const {
    // Of the squares below: what is no shorter by more may be dropped early.
    constexpr double rounding = 1e-12;
    const double length = quad.length(a, b), toA = quad.length(a, target), toB = quad.length(b, target);
    if (length == 0) return infinity;
    const double fromA = nodeAt(quad.corners[a]).distance, fromB = nodeAt(quad.corners[b]).distance;
    const double sourceX = (fromA * fromA - fromB * fromB + length * length) / (2 * length);
    const double sourceSquare = fromA * fromA - sourceX * sourceX;
    if (sourceSquare < 0) return infinity;
    const double x = (toA * toA - toB * toB + length * length) / (2 * length);
    const double aside = (x - sourceX) * (x - sourceX), limitSquare = limit * limit;
    // Spares the square roots below.
    if ((aside + sourceSquare) * (1 - rounding) >= limitSquare) return infinity;
    const double y = std::sqrt(std::max(toA * toA - x * x, 0.0));
    const double sourceY = std::sqrt(sourceSquare), height = y + sourceY;
    const double crossing = sourceX * y + x * sourceY; // multiplied by the height
    if (height == 0 || crossing < 0 || crossing > length * height) return infinity;
    const double square = aside + height * height;
    return square < limitSquare ? std::sqrt(square) : infinity;
}

} // namespace qm
