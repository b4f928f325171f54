#include "bspline/border_normals.h"

#include <cstddef>

namespace qm {

std::vector<double> normalParameters(int edges) {
    std::vector<double> parameters;
    for (int k = 0; k < edges; ++k)
        for (const double share : normalShares)
            parameters.push_back(k + share);
    return parameters;
}

Point unitNormalAcross(const Point& normal, const Point& tangent) {
    const double square = tangent.sqrnorm();
    if (!(square > 0)) return {0, 0, 0};
    const Point across = normal - (normal | tangent) / square * tangent;
    const double length = across.norm();
    return length > 0.5 ? Point(across / length) : Point(0, 0, 0);
}

std::vector<SurfacePoint> pointsOnBorder(const Patch& patch, std::size_t direction, std::size_t end) {
    const auto range = domain(patch);
    const std::size_t across = 1 - direction;
    const BasisValues there = basisValues(patch.knots[across], patch.degree[across], range[across][end]);
    const auto parameters = normalParameters(static_cast<int>(range[direction][1]));
    std::vector<SurfacePoint> points;
    for (const BasisValues& along : basisTable(patch.knots[direction], patch.degree[direction], parameters))
        points.push_back(direction == 0 ? evaluate(patch, along, there) : evaluate(patch, there, along));
    return points;
}

std::vector<Point> normalsOnBorder(const Patch& patch, std::size_t direction, std::size_t end) {
    std::vector<Point> normals;
    for (const SurfacePoint& on : pointsOnBorder(patch, direction, end))
        normals.push_back(unitNormal(on.du, on.dv));
    return normals;
}

OnBorder<std::vector<double>> anglesOff(const OnBorder<std::vector<Point>>& normals,
                                        const OnBorder<SplineCurve>& border, const Patch& patch) {
    OnBorder<std::vector<double>> angles;
    for (std::size_t d = 0; d < 2; ++d)
        for (std::size_t end = 0; end < 2; ++end) {
            const auto own = normalsOnBorder(patch, d, end);
            const auto parameters = normalParameters(static_cast<int>(border[d][end].length()));
            for (std::size_t k = 0; k < normals[d][end].size(); ++k) {
                const Point tangent = derivative(border[d][end], parameters[k]);
                angles[d][end].push_back(
                    angleInDegrees(own[k], unitNormalAcross(normals[d][end][k], tangent)));
            }
        }
    return angles;
}

} // namespace qm
