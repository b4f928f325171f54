#include "mesh/nesting.h"

#include "base/at.h"
#include "mesh/bounding_box.h"
#include "mesh/quad_geometry.h"
#include "mesh/topology.h"

#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/geometry/strategies/strategies.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

namespace qm {
namespace {

namespace index = boost::geometry::index;

using Corner = boost::geometry::model::point<double, 2, boost::geometry::cs::cartesian>;
using Box = boost::geometry::model::box<Corner>;

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

/// Tells quickly whether points are inside a part.
class Inside {
public:
    Inside(const QuadMesh& mesh, const std::vector<FaceId>& faces) {
        std::vector<std::pair<Box, std::size_t>> boxes;
        for (const FaceId face : faces)
            for (const auto& [a, b, c] : halvesOf(mesh, face)) {
                const Triangle& own = triangles_.emplace_back(Triangle{seen(a), seen(b), seen(c)});
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

Point firstCorner(const QuadMesh& mesh, const std::vector<FaceId>& faces) {
    return mesh.point(*mesh.cfv_iter(faces.front()));
}

/// Size and place of a part.
struct Extent {
    double volume = 0; ///< times six; negative if the faces look inwards
    BoundingBox box;
};

Extent extentOf(const QuadMesh& mesh, const std::vector<FaceId>& faces) {
    const Point origin = firstCorner(mesh, faces);
    Extent extent{0, {origin, origin}};
    for (const FaceId face : faces)
        for (const Triangle& triangle : halvesOf(mesh, face)) {
            const auto& [a, b, c] = triangle;
            extent.volume += (a - origin) | ((b - origin) % (c - origin));
            for (const Point& corner : triangle)
                extent.box.include(corner);
        }
    return extent;
}

bool contains(const BoundingBox& outer, const BoundingBox& inner) {
    for (unsigned k = 0; k < 3; ++k)
        if (inner.low[k] < outer.low[k] || inner.high[k] > outer.high[k]) return false;
    return true;
}

} // namespace

std::vector<std::vector<FaceId>> closedComponents(const QuadMesh& mesh) {
    const Components pieces = components(mesh);
    std::vector<std::vector<FaceId>> faces(at(pieces.count));
    for (const FaceId face : mesh.faces())
        faces[at(pieces.ofVertex[at(*mesh.cfv_iter(face))])].push_back(face);
    for (const VertexId vertex : mesh.vertices())
        if (mesh.is_boundary(vertex)) faces[at(pieces.ofVertex[at(vertex)])].clear();
    return faces;
}

std::vector<Nesting> nestingOf(const QuadMesh& mesh, const std::vector<std::vector<FaceId>>& parts) {
    std::vector<Nesting> result(parts.size());
    std::vector<BoundingBox> boxes(parts.size());
    std::vector<std::pair<double, std::size_t>> bySize; // the largest first
    for (std::size_t k = 0; k < parts.size(); ++k) {
        if (parts[k].empty()) continue;
        const Extent extent = extentOf(mesh, parts[k]);
        result[k].inward = extent.volume < 0;
        boxes[k] = extent.box;
        bySize.emplace_back(-std::abs(extent.volume), k);
    }
    std::ranges::sort(bySize);
    std::vector<std::optional<std::size_t>> around(parts.size());
    for (std::size_t rank = 0; rank < bySize.size(); ++rank) {
        const std::size_t part = bySize[rank].second;
        // All larger ones have been here: the last one that this one was found in is the smallest around it.
        const auto& outer = around[part];
        if (outer && !result[*outer].cavityOf && result[*outer].inward != result[part].inward)
            result[part] = {result[*outer].inward, outer};
        std::optional<Inside> inside; // made only if there is something to ask
        for (std::size_t smaller = rank + 1; smaller < bySize.size(); ++smaller) {
            const std::size_t other = bySize[smaller].second;
            if (!contains(boxes[part], boxes[other])) continue;
            if (!inside) inside.emplace(mesh, parts[part]);
            if (inside->holds(firstCorner(mesh, parts[other]))) around[other] = part;
        }
    }
    return result;
}

} // namespace qm
