/// \file B-spline surfaces, evaluated anew by the recursion of Cox and de Boor.
#pragma once

#include "check/document/checked_document.h"
#include "check/mesh/vectors.h"

#include <array>
#include <vector>

namespace qm::check {

constexpr int maxDegree = 9;

/// Where surfaces are checked by samples: so many steps along an edge of the mesh.
constexpr int samplesPerEdge = 16;

/// u and v, or s and t.
using Parameters = std::array<double, 2>;

/// The point of a surface and its derivatives by u and v.
struct SurfacePoint {
    Place point{};
    Vector alongU{};
    Vector alongV{};
};

/// \param patch  of degrees 1 to `maxDegree`, with knots that do not decrease, as many as control points +
/// degree + 1 in each direction
/// \param u, v   taken to the nearest end of the domain, knots [degree] to [count], where they are outside
[[nodiscard]] SurfacePoint evaluate(const SurfacesPart::Patch& patch, double u, double v);

/// The points (us[i], vs[j]), at j * us.size() + i, which costs a fraction of asking for each.
/// \param us  ascending, at least one
[[nodiscard]] std::vector<SurfacePoint> evaluateLattice(const SurfacesPart::Patch& patch,
                                                        const std::vector<double>& us,
                                                        const std::vector<double>& vs);

} // namespace qm::check
