#include "check/surfaces/bilinear_quad.h"

#include "base/at.h"

namespace qm::check {

Place BilinearQuad::at(double s, double t) const {
    const std::array<double, 4> weight{(1 - s) * (1 - t), s * (1 - t), s * t, (1 - s) * t};
    Place sum{};
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t k = 0; k < 3; ++k)
            sum[k] += weight[i] * corners[i][k];
    return sum;
}

Vector BilinearQuad::normal() const {
    return cross(minus(corners[2], corners[0]), minus(corners[3], corners[1]));
}

bool BilinearQuad::isConvex(double minSine) const {
    const Vector outwards = normal();
    const double min = minSine * length(outwards);
    for (std::size_t k = 0; k < 4; ++k) {
        const Vector next = minus(corners[(k + 1) % 4], corners[k]);
        const Vector before = minus(corners[(k + 3) % 4], corners[k]);
        if (!(dot(cross(next, before), outwards) > min * length(next) * length(before))) return false;
    }
    return true;
}

BilinearQuad quadOf(const CheckedMesh& mesh, int face) {
    const auto& vertices = mesh.quads[at(face)];
    BilinearQuad quad{};
    for (std::size_t k = 0; k < 4; ++k)
        quad.corners[k] = mesh.points[at(vertices[k])];
    return quad;
}

} // namespace qm::check
