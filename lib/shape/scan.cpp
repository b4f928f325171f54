#include "shape/scan.h"

#include "base/at.h"
#include "shape/quad_list.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace qm {
namespace {

/// The same numbers everywhere, which the distributions of the standard library do not promise.
class NormalNumbers {
public:
    explicit NormalNumbers(std::uint64_t seed) : engine_(seed) {}
    /// Box and Muller's formula.
    double next() {
        const double radius = std::sqrt(-2 * std::log(1 - uniform()));
        return radius * std::cos(2 * std::numbers::pi * uniform());
    }

private:
    /// From 0 to 1, exclusive.
    double uniform() { return std::ldexp(static_cast<double>(engine_() >> 11U), -53); }

    std::mt19937_64 engine_;
};

} // namespace

Triangles trianglesOf(const QuadList& list) {
    Triangles triangles{list.points, {}};
    triangles.faces.reserve(2 * list.quads.size());
    for (const auto& [a, b, c, d] : list.quads) {
        const auto length = [&](int from, int to) {
            return (list.points[at(to)] - list.points[at(from)]).sqrnorm();
        };
        if (length(a, c) <= length(b, d)) {
            triangles.faces.push_back({a, b, c});
            triangles.faces.push_back({a, c, d});
        } else {
            triangles.faces.push_back({a, b, d});
            triangles.faces.push_back({b, c, d});
        }
    }
    return triangles;
}

void addNoise(Triangles& triangles, double deviation, std::uint64_t seed) {
    std::vector<Point> normals(triangles.points.size(), Point(0, 0, 0));
    for (const auto& face : triangles.faces) {
        const auto corner = [&](std::size_t k) -> const Point& { return triangles.points[at(face[k])]; };
        const Point normal = (corner(1) - corner(0)) % (corner(2) - corner(0));
        for (const int k : face)
            normals[at(k)] += normal;
    }
    NormalNumbers numbers(seed);
    for (std::size_t k = 0; k < normals.size(); ++k) {
        const double length = std::max(normals[k].norm(), std::numeric_limits<double>::min());
        triangles.points[k] += deviation * numbers.next() / length * normals[k];
    }
}

} // namespace qm
