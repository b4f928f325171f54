#include "mesh/nesting.h"

#include "mesh/bounding_box.h"

#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/geometry/strategies/strategies.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace qm {
namespace {

namespace index = boost::geometry::index;

using Corner = boost::geometry::model::point<double, 2, boost::geometry::cs::cartesian>;
using Box = boost::geometry::model::box<Corner>;
using Triangle = std::array<Point, 3>;

/// Seen along a direction that is hardly ever that of a part's edges or faces, so that rays meet faces and
/// not edges.
Point seen(const Point& point) {
    static const std::array<Point, 3> axes = [] {
        const Point along = Point(0.5257, 0.3141, 0.7905).normalized();
        const Point across = (along % Point(0.2718, 0.5772, 0.1618)).normalized();
        return std::array{across, along % across, along};
    }();
    return {axes[0] | point, axes[1] | point, axes[2] | point};
}

/// Twice the area of a triangle from above; negative if it is clockwise.
double areaFromAbove(const Point& a, const Point& b, const Point& c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// 1 or -1 if a ray upwards from the point meets the triangle, by the side it comes from; otherwise 0.
int crossing(const Triangle& triangle, const Point& from) {
    const auto& [a, b, c] = triangle;
    const std::array<double, 3> parts{areaFromAbove(from, b, c), areaFromAbove(a, from, c),
                                      areaFromAbove(a, b, from)};
    const auto isNegative = [](double part) { return part < 0; };
    const auto negative = std::ranges::count_if(parts, isNegative);
    if (negative != 0 && negative != 3) return 0;
    const double whole = parts[0] + parts[1] + parts[2];
    if (whole == 0) return 0;
    const double height = (parts[0] * a[2] + parts[1] * b[2] + parts[2] * c[2]) / whole;
    if (!(height > from[2])) return 0;
    return whole > 0 ? 1 : -1;
}

/// Tells quickly whether points are inside a mesh.
class Inside {
public:
    explicit Inside(const ClosedMesh& mesh) {
        std::vector<std::pair<Box, std::size_t>> boxes;
        for (const Triangle& triangle : mesh) {
            const Triangle& own =
                triangles_.emplace_back(Triangle{seen(triangle[0]), seen(triangle[1]), seen(triangle[2])});
            const BoundingBox box = boundingBoxOf(own);
            boxes.emplace_back(Box{{box.low[0], box.low[1]}, {box.high[0], box.high[1]}}, boxes.size());
        }
        tree_ = Tree(boxes);
    }

    [[nodiscard]] bool holds(const Point& point) const {
        const Point from = seen(point);
        std::vector<std::pair<Box, std::size_t>> above;
        tree_.query(index::intersects(Corner{from[0], from[1]}), std::back_inserter(above));
        int crossings = 0;
        for (const auto& entry : above)
            crossings += crossing(triangles_[entry.second], from);
        return crossings != 0;
    }

private:
    using Tree = index::rtree<std::pair<Box, std::size_t>, index::linear<16>>;

    std::vector<Triangle> triangles_;
    Tree tree_;
};

BoundingBox boxOf(const ClosedMesh& mesh) {
    BoundingBox box{mesh.front().front(), mesh.front().front()};
    for (const Triangle& triangle : mesh)
        for (const Point& point : triangle) {
            box.low.minimize(point);
            box.high.maximize(point);
        }
    return box;
}

bool contains(const BoundingBox& outer, const BoundingBox& inner) {
    for (unsigned k = 0; k < 3; ++k)
        if (inner.low[k] < outer.low[k] || inner.high[k] > outer.high[k]) return false;
    return true;
}

/// Six times the volume inside; negative if the triangles look inwards.
double sixfoldVolume(const ClosedMesh& mesh) {
    double sum = 0;
    for (const auto& [a, b, c] : mesh) {
        const Point& origin = mesh.front().front();
        sum += (a - origin) | ((b - origin) % (c - origin));
    }
    return sum;
}

} // namespace

void addQuad(const QuadMesh& mesh, FaceId face, ClosedMesh& triangles) {
    std::vector<Point> corners;
    for (const VertexId vertex : mesh.fv_range(face))
        corners.push_back(mesh.point(vertex));
    for (std::size_t k = 2; k < corners.size(); ++k)
        triangles.push_back({corners[0], corners[k - 1], corners[k]});
}

std::vector<Nesting> nestingOf(const std::vector<ClosedMesh>& meshes) {
    std::vector<Nesting> result(meshes.size());
    std::vector<BoundingBox> boxes(meshes.size());
    std::vector<std::pair<double, std::size_t>> bySize; // the largest first
    for (std::size_t k = 0; k < meshes.size(); ++k) {
        if (meshes[k].empty()) continue;
        const double volume = sixfoldVolume(meshes[k]);
        result[k].inward = volume < 0;
        boxes[k] = boxOf(meshes[k]);
        bySize.emplace_back(-std::abs(volume), k);
    }
    std::ranges::sort(bySize);
    std::vector<std::optional<std::size_t>> around(meshes.size());
    for (std::size_t rank = 0; rank < bySize.size(); ++rank) {
        const std::size_t mesh = bySize[rank].second;
        // All larger ones have been here: the last one that this one was found in is the smallest around it.
        const auto& outer = around[mesh];
        if (outer && !result[*outer].cavityOf && result[*outer].inward != result[mesh].inward)
            result[mesh] = {result[*outer].inward, outer};
        std::optional<Inside> inside; // made only if there is something to ask
        for (std::size_t smaller = rank + 1; smaller < bySize.size(); ++smaller) {
            const std::size_t other = bySize[smaller].second;
            if (!contains(boxes[mesh], boxes[other])) continue;
            if (!inside) inside.emplace(meshes[mesh]);
            if (inside->holds(meshes[other].front().front())) around[other] = mesh;
        }
    }
    return result;
}

} // namespace qm
