#include "bspline/measure/shape_measures.h"

#include "bspline/measure/gauss_points.h"
#include "bspline/splines/eigen_point.h"
#include "bspline/splines/evaluate.h"
#include "mesh/angle_between.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace qm {
namespace {

/// What a surface is like at a point.
struct LocalShape {
    Eigen::Vector3d normal; ///< of unit length
    double bending;         ///< sum of the squared curvatures, times the area for a unit of the parameters'
};

/// A polynomial with its derivatives.
class DerivedPiece {
public:
    explicit DerivedPiece(const BezierPiece& piece) : du_(derivative(piece, 0)), dv_(derivative(piece, 1)) {}

    /// None where the surface has no normal. Curvatures do not depend on the parameters, areas do: they are
    /// those for the unit square.
    [[nodiscard]] std::optional<LocalShape> at(double u, double v) const {
        const PiecePoint alongU = evaluate(du_, u, v);
        const PiecePoint alongV = evaluate(dv_, u, v);
        const Eigen::Vector3d& du = alongU.position;
        const Eigen::Vector3d& dv = alongV.position;
        const double uu = du.squaredNorm();
        const double uv = du.dot(dv);
        const double vv = dv.squaredNorm();
        const double area = uu * vv - uv * uv;
        if (!(area > 1e-10 * uu * vv)) return std::nullopt;
        const Eigen::Vector3d normal = du.cross(dv) / std::sqrt(area);
        const double l = alongU.du.dot(normal);
        const double m = alongU.dv.dot(normal);
        const double n = alongV.dv.dot(normal);
        const double twiceMean = (vv * l - 2 * uv * m + uu * n) / area;
        const double gaussian = (l * n - m * m) / area;
        return LocalShape{normal, (twiceMean * twiceMean - 2 * gaussian) * std::sqrt(area)};
    }

private:
    BezierPiece du_;
    BezierPiece dv_;
};

} // namespace

void ShapeMeasures::add(const ShapeMeasures& other) {
    largestNormalDeviation = std::max(largestNormalDeviation, other.largestNormalDeviation);
    squaredNormalDeviation += other.squaredNormalDeviation;
    area += other.area;
    for (std::size_t k = 0; k < 2; ++k)
        bending[k] += other.bending[k];
}

double ShapeMeasures::rmsNormalDeviation() const {
    return area > 0 ? std::sqrt(squaredNormalDeviation / area) : 0;
}

double ShapeMeasures::bendingRatio() const {
    constexpr double plane = 1e-6; // bending of a surface that is plane but for rounding
    return (bending[0] + plane) / (bending[1] + plane);
}

ShapeMeasures measureShape(const PairedSurfaces& surfaces, std::size_t patch) {
    ShapeMeasures measures;
    BezierPiece piece;
    for (const Cell& cell : surfaces.cells(patch)) {
        surfaces.get(0, cell, piece);
        const DerivedPiece surface(piece);
        surfaces.get(1, cell, piece);
        const DerivedPiece reference(piece);
        for (const GaussPoint& place : gaussPoints(surfaces.box(cell))) {
            const auto own = surface.at(place.u, place.v);
            const auto other = reference.at(place.u, place.v);
            if (!own || !other) continue;
            const double angle = degreesBetween(point(own->normal), point(other->normal));
            ShapeMeasures here;
            here.largestNormalDeviation = angle;
            here.squaredNormalDeviation = place.area * angle * angle;
            here.area = place.area;
            here.bending = {own->bending / 4, other->bending / 4};
            measures.add(here);
        }
    }
    return measures;
}

} // namespace qm
