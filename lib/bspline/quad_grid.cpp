#include "bspline/quad_grid.h"

#include "bspline/evaluate.h"

#include <algorithm>
#include <cstddef>

namespace qm {

QuadCorners QuadGrid::corners(int i, int j) const {
    const auto step = static_cast<std::size_t>(size_[0]) + 1;
    const std::size_t first = static_cast<std::size_t>(j) * step + static_cast<std::size_t>(i);
    return {points_[first], points_[first + 1], points_[first + step + 1], points_[first + step]};
}

Point QuadGrid::at(double u, double v) const {
    const int i = std::clamp(static_cast<int>(u), 0, size_[0] - 1);
    const int j = std::clamp(static_cast<int>(v), 0, size_[1] - 1);
    return bilinear(corners(i, j), u - i, v - j);
}

Point QuadGrid::normalAtCentre(int i, int j) const {
    const QuadCorners c = corners(i, j);
    return unitNormal(c[1] + c[2] - c[0] - c[3], c[2] + c[3] - c[0] - c[1]);
}

} // namespace qm
