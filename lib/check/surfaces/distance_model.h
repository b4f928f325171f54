/// \file What the distance of a surface from a point becomes as the parameters change a little.
#pragma once

#include "check/mesh/vectors.h"
#include "check/surfaces/spline.h"

#include <array>

namespace qm::check {

/// The square of the distance as a quadratic function of changes of the parameters.
struct DistanceModel {
    std::array<double, 2> slopes{};  ///< half of its decrease by each parameter
    std::array<double, 2> squares{}; ///< half of its second derivatives by each
    double mixed = 0;                ///< and by both
};

/// As if the surface were its tangent plane.
/// \param away  from the surface to the point
[[nodiscard]] DistanceModel onTangents(const SurfacePoint& here, const Vector& away);

/// Where in the box [0, max] a model has its minimum, if it has one, or else where on the sides it is least.
[[nodiscard]] Parameters minimumOf(const DistanceModel& model, const Parameters& at, const Parameters& max);

/// As the surface bends, if the square has a minimum by that; otherwise as on the tangent plane.
/// \param surface  gives a `SurfacePoint` for parameters in the box [0, max]
template <class Surface>
DistanceModel onSurface(const Surface& surface, const SurfacePoint& here, const Vector& away,
                        const Parameters& at, const Parameters& max) {
    constexpr double step = 1e-5; // of the box, for differences of tangents
    const DistanceModel plane = onTangents(here, away);
    DistanceModel model = plane;
    for (std::size_t k = 0; k < 2; ++k) {
        const double change = step * (2 * at[k] < max[k] ? max[k] : -max[k]);
        Parameters beside = at;
        beside[k] += change;
        const SurfacePoint there = surface(beside);
        const Vector ofU = minus(there.alongU, here.alongU);
        const Vector ofV = minus(there.alongV, here.alongV);
        model.squares[k] -= dot(k == 0 ? ofU : ofV, away) / change;
        if (k == 0) model.mixed -= dot(ofV, away) / change;
    }
    const bool hasMinimum =
        model.squares[0] > 0 && model.squares[0] * model.squares[1] > model.mixed * model.mixed;
    return hasMinimum ? model : plane;
}

} // namespace qm::check
