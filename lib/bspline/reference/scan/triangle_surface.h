/// \file Finds the nearest point of a triangulated surface.
#pragma once

#include "base/infinity.h"
#include "mesh/triangles/triangles.h"

#include <array>
#include <cstddef>
#include <memory>
#include <optional>

namespace qm {

/// Finds triangles by a packed R-tree (Boost.Geometry). May be used from several threads.
/// Measured against Eigen's KdBVH for 90,000 points beside a bent sphere, at -O2: with 160,000 triangles a
/// query takes 1.9 us instead of 2.5 near the surface, and 2.7 instead of 4.2 at a hundredth of its size
/// away; with 4,000,000 triangles 5.0 instead of 8.5, and building the tree takes 1.7 s instead of 1.9.
class TriangleSurface {
public:
    struct Nearest {
        Point position;
        /// Of unit length: the mean of the normals around each corner, interpolated; none where that is 0.
        std::optional<Point> normal;
        double distance;
        bool onBoundary; ///< on a side that only one triangle has, or at an end of such a side
        std::size_t face;
    };

    /// Builds the tree in O(n log n) time. \pre every triangle has three different points with finite
    /// coordinates
    explicit TriangleSurface(const Triangles& triangles);
    ~TriangleSurface();
    TriangleSurface(TriangleSurface&&) noexcept;
    TriangleSurface& operator=(TriangleSurface&&) noexcept;

    /// \return nothing if no triangle is within reach
    [[nodiscard]] std::optional<Nearest> nearest(const Point& point, double maxDistance = infinity) const;

    /// Among the intersections with the line through a point, at most `maxDistance` away on either side,
    /// finds the nearest one whose normal makes an angle with the line of at least the given cosine.
    /// \param direction  of unit length
    /// \return nothing if there is none
    [[nodiscard]] std::optional<Nearest> alongLine(const Point& point, const Point& direction,
                                                   double maxDistance, double minCosine = -1) const;

    /// The cosine of the angle between a direction of unit length and the normal at a place that was found:
    /// that of its triangle or the mean one there, whichever is nearer, because on a sharp edge the triangle
    /// is that of either side. -1 where there is no normal.
    [[nodiscard]] double cosineAt(const Nearest& place, const Point& direction) const;

    [[nodiscard]] std::size_t size() const; ///< number of triangles
    /// The corners of a triangle that was found.
    [[nodiscard]] std::array<Point, 3> corners(std::size_t face) const;
    /// Its distance from any point.
    [[nodiscard]] double distance(std::size_t face, const Point& point) const;

    /// The standard deviation of its vertices from smooth surfaces; see `vertexNoise`.
    [[nodiscard]] std::optional<double> noise() const;

private:
    struct Tree;
    std::unique_ptr<Tree> tree_;
};

} // namespace qm
