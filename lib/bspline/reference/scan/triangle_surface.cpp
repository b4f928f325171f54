#include "bspline/reference/scan/triangle_surface.h"

#include "base/at.h"
#include "base/infinity.h"
#include "bspline/reference/scan/vertex_noise.h"
#include "bspline/splines/eigen_point.h"
#include "mesh/quad_geometry.h"
#include "mesh/triangles/triangle_edges.h"

#include <Eigen/Geometry>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/geometry/strategies/strategies.hpp>
#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace qm {
namespace {

namespace index = boost::geometry::index;
using Eigen::Vector3d;
using TreePoint = boost::geometry::model::point<double, 3, boost::geometry::cs::cartesian>;
using Box = boost::geometry::model::box<TreePoint>;
using Entry = std::pair<Box, std::uint32_t>;

TreePoint treePoint(const Vector3d& point) {
    return {point[0], point[1], point[2]};
}

Box boxAround(const Vector3d& a, const Vector3d& b) {
    return {treePoint(a.cwiseMin(b)), treePoint(a.cwiseMax(b))};
}

/// A point of a triangle by its weights; those that are 0 are exactly 0.
using Weights = Vector3d;

/// The nearest point of a segment, as the weight of its end.
double nearestOfSegment(const Vector3d& from, const Vector3d& to, const Vector3d& point) {
    const Vector3d along = to - from;
    const double length = along.squaredNorm();
    return length > 0 ? std::clamp((point - from).dot(along) / length, 0.0, 1.0) : 0;
}

/// The foot of the perpendicular where it lies inside, or else the best point of the three sides.
Weights nearestWeights(const std::array<Vector3d, 3>& corners, const Vector3d& point) {
    const Vector3d normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    const double square = normal.squaredNorm();
    if (square > 0) {
        Weights inside;
        for (int k = 0; k < 3; ++k) {
            const Vector3d& a = corners[at((k + 1) % 3)];
            const Vector3d& b = corners[at((k + 2) % 3)];
            inside[k] = (a - point).cross(b - point).dot(normal) / square;
        }
        if (inside.minCoeff() >= 0) return inside / inside.sum();
    }
    Weights best;
    double bestDistance = infinity;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t next = (k + 1) % 3;
        const double t = nearestOfSegment(corners[k], corners[next], point);
        const double distance = (corners[k] + t * (corners[next] - corners[k]) - point).squaredNorm();
        if (!(distance < bestDistance)) continue;
        bestDistance = distance;
        best.setZero();
        best[eigenIndex(k)] = 1 - t;
        best[eigenIndex(next)] = t;
    }
    return best;
}

} // namespace

struct TriangleSurface::Tree {
    std::vector<Vector3d> points;
    std::vector<Vector3d> normals; ///< by point, of unit length or 0
    std::vector<std::array<int, 3>> faces;
    BoundarySides boundary;
    index::rtree<Entry, index::rstar<8>> boxes;

    explicit Tree(const Triangles& triangles) : faces(triangles.faces), boundary(boundarySides(triangles)) {
        points.reserve(triangles.points.size());
        for (const Point& point : triangles.points)
            points.push_back(vector(point));
        normals.assign(points.size(), Vector3d::Zero());
        std::vector<Entry> entries;
        entries.reserve(faces.size());
        for (std::size_t face = 0; face < faces.size(); ++face) {
            const auto [a, b, c] = cornersOf(face);
            const Vector3d normal = (b - a).cross(c - a);
            for (const int corner : faces[face])
                normals[at(corner)] += normal;
            entries.emplace_back(
                Box(treePoint(a.cwiseMin(b).cwiseMin(c)), treePoint(a.cwiseMax(b).cwiseMax(c))),
                static_cast<std::uint32_t>(face));
        }
        for (Vector3d& normal : normals)
            normal.stableNormalize();
        boxes = index::rtree<Entry, index::rstar<8>>(entries);
    }

    [[nodiscard]] std::array<Vector3d, 3> cornersOf(std::size_t face) const {
        std::array<Vector3d, 3> corners;
        std::ranges::transform(faces[face], corners.begin(), [&](int k) { return points[at(k)]; });
        return corners;
    }

    [[nodiscard]] Vector3d interpolated(std::size_t face, const Weights& weights,
                                        const std::vector<Vector3d>& values) const {
        Vector3d sum = Vector3d::Zero();
        for (std::size_t k = 0; k < 3; ++k)
            sum += weights[eigenIndex(k)] * values[at(faces[face][k])];
        return sum;
    }

    [[nodiscard]] bool onBoundary(std::size_t face, const Weights& weights) const {
        for (std::size_t k = 0; k < 3; ++k) {
            const double opposite = weights[eigenIndex((k + 2) % 3)];
            if (opposite == 0 && boundary.sides[3 * face + k]) return true;
            if (weights[eigenIndex(k)] == 1 && boundary.points[at(faces[face][k])]) return true;
        }
        return false;
    }

    [[nodiscard]] Nearest described(std::uint32_t face, const Weights& weights, double distance) const {
        const Vector3d normal = interpolated(face, weights, normals).stableNormalized();
        return {qm::point(interpolated(face, weights, points)),
                normal.isZero(0) ? std::nullopt : std::optional(qm::point(normal)), distance,
                onBoundary(face, weights), face};
    }
};

std::size_t TriangleSurface::size() const {
    return tree_->faces.size();
}

std::array<Point, 3> TriangleSurface::corners(std::size_t face) const {
    const auto [a, b, c] = tree_->cornersOf(face);
    return {point(a), point(b), point(c)};
}

double TriangleSurface::cosineAt(const Nearest& place, const Point& direction) const {
    const std::optional<Point> ofTriangle = triangleNormal(corners(place.face));
    return std::max(ofTriangle ? *ofTriangle | direction : -1, place.normal ? *place.normal | direction : -1);
}

double TriangleSurface::distance(std::size_t face, const Point& place) const {
    const Vector3d point = vector(place);
    const Weights weights = nearestWeights(tree_->cornersOf(face), point);
    return (tree_->interpolated(face, weights, tree_->points) - point).norm();
}

std::optional<double> TriangleSurface::noise() const {
    return vertexNoise(tree_->points, tree_->faces, tree_->normals);
}

TriangleSurface::TriangleSurface(const Triangles& triangles) : tree_(std::make_unique<Tree>(triangles)) {}
TriangleSurface::~TriangleSurface() = default;
TriangleSurface::TriangleSurface(TriangleSurface&&) noexcept = default;
TriangleSurface& TriangleSurface::operator=(TriangleSurface&&) noexcept = default;

std::optional<TriangleSurface::Nearest> TriangleSurface::nearest(const Point& place,
                                                                 double maxDistance) const {
    const Vector3d point = vector(place);
    double best = maxDistance * maxDistance;
    std::uint32_t bestFace = 0;
    Weights bestWeights = Weights::Zero();
    const auto consider = [&](const Entry& entry) {
        if (boost::geometry::comparable_distance(treePoint(point), entry.first) > best) return;
        const Weights weights = nearestWeights(tree_->cornersOf(entry.second), point);
        const double distance =
            (tree_->interpolated(entry.second, weights, tree_->points) - point).squaredNorm();
        // Of equally near ones the first, so that the order of the tree does not matter.
        if (distance > best || (distance == best && !bestWeights.isZero(0) && entry.second > bestFace))
            return;
        best = distance;
        bestFace = entry.second;
        bestWeights = weights;
    };
    // The triangle in the nearest box bounds the distance; a nearer one has a box that meets the cube.
    const auto all = boost::make_function_output_iterator(consider);
    tree_->boxes.query(index::nearest(treePoint(point), 1), all);
    const Vector3d reach = Vector3d::Constant(std::sqrt(best));
    tree_->boxes.query(index::intersects(boxAround(point - reach, point + reach)), all);
    if (bestWeights.isZero(0)) return std::nullopt;
    return tree_->described(bestFace, bestWeights, std::sqrt(best));
}

std::optional<TriangleSurface::Nearest> TriangleSurface::alongLine(const Point& place, const Point& direction,
                                                                   double maxDistance,
                                                                   double minCosine) const {
    const Vector3d point = vector(place);
    const Vector3d along = vector(direction);
    std::optional<Nearest> best;
    const auto consider = [&](const Entry& entry) {
        const auto corners = tree_->cornersOf(entry.second);
        // Volumes that the line's direction spans with the sides, seen from the point.
        Weights weights;
        for (std::size_t k = 0; k < 3; ++k)
            weights[eigenIndex(k)] =
                (corners[(k + 1) % 3] - point).cross(corners[(k + 2) % 3] - point).dot(along);
        const double sum = weights.sum();
        weights /= sum; // of no use if the triangle is seen edge on
        if (sum == 0 || !(weights.minCoeff() >= 0)) return;
        const double distance =
            std::abs((tree_->interpolated(entry.second, weights, tree_->points) - point).dot(along));
        if (!(distance <= (best ? best->distance : maxDistance))) return;
        if (best && distance == best->distance && entry.second > best->face) return;
        const Nearest hit = tree_->described(entry.second, weights, distance);
        if ((hit.normal ? *hit.normal | direction : 0) >= minCosine) best = hit;
    };
    tree_->boxes.query(index::intersects(boxAround(point - maxDistance * along, point + maxDistance * along)),
                       boost::make_function_output_iterator(consider));
    return best;
}

} // namespace qm
