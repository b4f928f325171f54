/// \file A segment's quads over the parameters of its patch.
#pragma once

#include "bspline/mesh_distance.h"

#include <array>
#include <vector>

namespace qm {

/// A grid of points as a piecewise bilinear surface: point (i, j) lies at u = i, v = j.
class QuadGrid {
public:
    /// \param points  row by row, (m + 1) x (n + 1) of them \param size  m and n, at least 1
    QuadGrid(std::vector<Point> points, const std::array<int, 2>& size)
        : points_(std::move(points)), size_(size) {}

    [[nodiscard]] const std::array<int, 2>& size() const { return size_; }
    /// Of the quad between i and i + 1, j and j + 1.
    [[nodiscard]] QuadCorners corners(int i, int j) const;
    /// Outside its range the outermost quads go on.
    [[nodiscard]] Point at(double u, double v) const;
    [[nodiscard]] Point normalAtCentre(int i, int j) const;

private:
    std::vector<Point> points_;
    std::array<int, 2> size_;
};

} // namespace qm
