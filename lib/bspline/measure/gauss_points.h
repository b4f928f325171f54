/// \file Gauss's rule with two points in each direction, exact for bicubics.
#pragma once

#include "bspline/splines/surfaces.h"

#include <array>
#include <cmath>

namespace qm {

struct GaussPoint {
    double u = 0; ///< within the box, from 0 to 1
    double v = 0;
    Parameters at{}; ///< its parameters
    double area = 0; ///< that it stands for: a quarter of the box
};

[[nodiscard]] inline std::array<GaussPoint, 4> gaussPoints(const ParameterBox& box) {
    constexpr std::array<double, 2> nodes = {0.21132486540518712, 0.78867513459481288};
    const auto& [us, vs] = box;
    const double area = (us[1] - us[0]) * (vs[1] - vs[0]) / 4;
    std::array<GaussPoint, 4> points{};
    auto* point = points.data();
    for (const double v : nodes)
        for (const double u : nodes)
            *point++ = {u, v, {std::lerp(us[0], us[1], u), std::lerp(vs[0], vs[1], v)}, area};
    return points;
}

} // namespace qm
