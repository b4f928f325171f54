#include "bspline/fitting/energy/thin_plate.h"

#include "base/at.h"

#include <algorithm>

namespace qm {
namespace {

struct Stiffness {
    /// Weight of the square of a turn by one radian, in squared tolerances: with more, surfaces are fairer
    /// but need more control points.
    static constexpr double ofTurns = 0.1;
    /// Lower weights do not prevent surfaces from oscillating, higher ones prevent them from bending at all.
    static constexpr double min = 1e-4;
    static constexpr double max = 0.1;
    /// Factor where quads are stiff. Beside folded quads, stiff plates fold the more.
    static constexpr double ofStiff = 3;
    /// Quads that are even longer are mostly skewed as well and have no clear direction.
    static constexpr double maxAspect = 8;
};

ThinPlate plate(double weight, double aspect) {
    return {weight * aspect * aspect, 2 * weight, weight / (aspect * aspect)};
}

} // namespace

std::vector<ThinPlate> thinPlates(const ReferenceGrid& reference, const std::vector<bool>& isStiff,
                                  double tolerance) {
    const auto length = [&](int i, int j, int di, int dj) {
        return (reference.vertex(i + di, j + dj) - reference.vertex(i, j)).norm();
    };
    std::vector<ThinPlate> plates;
    for (int j = 0; j < reference.size[1]; ++j)
        for (int i = 0; i < reference.size[0]; ++i) {
            const double u = (length(i, j, 1, 0) + length(i, j + 1, 1, 0)) / 2;
            const double v = (length(i, j, 0, 1) + length(i + 1, j, 0, 1)) / 2;
            if (!(u * v > 0)) {
                plates.push_back(plate(Stiffness::min, 1));
                continue;
            }
            const double factor = isStiff[plates.size()] ? Stiffness::ofStiff : 1;
            const double weight = factor * Stiffness::ofTurns * tolerance * tolerance / (u * v);
            plates.push_back(plate(std::clamp(weight, Stiffness::min, factor * Stiffness::max),
                                   std::clamp(v / u, 1 / Stiffness::maxAspect, Stiffness::maxAspect)));
        }
    return plates;
}

std::vector<ThinPlate> softPlates(const std::array<int, 2>& size) {
    return std::vector<ThinPlate>(at(size[0]) * at(size[1]), plate(Stiffness::min, 1));
}

} // namespace qm
