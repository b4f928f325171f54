#include "bspline/reference/lattice/bilinear_quad.h"

#include <algorithm>
#include <cstddef>

namespace qm {

BilinearQuad::BilinearQuad(const std::array<Point, 4>& corners)
    : corners_(corners), normal_(unit((corners[2] - corners[0]) % (corners[3] - corners[1]))) {}

SurfacePoint BilinearQuad::evaluate(double s, double t) const {
    const auto& [a, b, c, d] = corners_;
    SurfacePoint point;
    point.position = (1 - t) * ((1 - s) * a + s * b) + t * ((1 - s) * d + s * c);
    point.du = (1 - t) * (b - a) + t * (c - d);
    point.dv = (1 - s) * (d - a) + s * (c - b);
    return point;
}

double BilinearQuad::minCosine() const {
    double min = 1;
    for (std::size_t k = 0; k < 4; ++k)
        min = std::min(min, normal_ | unit((corners_[(k + 1) % 4] - corners_[k]) %
                                           (corners_[(k + 3) % 4] - corners_[k])));
    return min;
}

BilinearQuad quadBelow(const ReferenceGrid& reference, int i, int j) {
    return BilinearQuad({reference.vertex(i, j), reference.vertex(i + 1, j), reference.vertex(i + 1, j + 1),
                         reference.vertex(i, j + 1)});
}

} // namespace qm
