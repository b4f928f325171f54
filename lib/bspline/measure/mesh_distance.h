/// \file The distance from any point to a quad mesh, taken as its bilinear quads.
#pragma once

#include "mesh/quad_mesh.h"

#include <array>
#include <memory>

namespace qm {

/// The corners of a bilinear quad in order; corner 0 is at (0, 0), corner 1 at (1, 0), corner 2 at (1, 1).
using QuadCorners = std::array<Point, 4>;

[[nodiscard]] Point bilinear(const QuadCorners& corners, double s, double t);

/// Distance from a point to a bilinear quad: the least over its four edges and the point inside that Newton's
/// iteration finds from the middle. Never less than the true distance.
[[nodiscard]] double distanceToQuad(const QuadCorners& corners, const Point& point);

/// Finds the nearest quads through a packed R-tree (Boost.Geometry). Safe to ask from several threads.
class MeshDistance {
public:
    explicit MeshDistance(const QuadMesh& mesh);
    ~MeshDistance();
    MeshDistance(MeshDistance&&) noexcept;
    MeshDistance& operator=(MeshDistance&&) noexcept;

    /// \param bound  a distance at which the mesh is known to have a point; the closer, the faster
    [[nodiscard]] double operator()(const Point& point, double bound) const;

private:
    struct Tree;
    std::unique_ptr<Tree> tree_;
};

} // namespace qm
