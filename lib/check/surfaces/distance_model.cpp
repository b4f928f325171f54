#include "check/surfaces/distance_model.h"

#include <algorithm>

namespace qm::check {

DistanceModel onTangents(const SurfacePoint& here, const Vector& away) {
    return {{dot(here.alongU, away), dot(here.alongV, away)},
            {dot(here.alongU, here.alongU), dot(here.alongV, here.alongV)},
            dot(here.alongU, here.alongV)};
}

Parameters minimumOf(const DistanceModel& model, const Parameters& at, const Parameters& max) {
    const auto& [slopes, squares, mixed] = model;
    const double determinant = squares[0] * squares[1] - mixed * mixed;
    if (determinant > 1e-12 * squares[0] * squares[1]) {
        const Parameters inner{at[0] + (slopes[0] * squares[1] - slopes[1] * mixed) / determinant,
                               at[1] + (slopes[1] * squares[0] - slopes[0] * mixed) / determinant};
        if (inner[0] >= 0 && inner[0] <= max[0] && inner[1] >= 0 && inner[1] <= max[1]) return inner;
    }
    // On a side of the box, only the other parameter is free.
    Parameters best = at;
    double min = 0; // square of the distance, beside that from here
    for (std::size_t k = 0; k < 2; ++k)
        for (const double side : {0.0, max[k]}) {
            const std::size_t other = 1 - k;
            const double across = side - at[k];
            const double alone = squares[other] > 0 ? (slopes[other] - mixed * across) / squares[other] : 0;
            Parameters to{};
            to[k] = side;
            to[other] = std::clamp(at[other] + alone, 0.0, max[other]);
            const double along = to[other] - at[other];
            const double change = across * (squares[k] * across - 2 * slopes[k]) +
                                  along * (squares[other] * along - 2 * slopes[other]) +
                                  2 * mixed * across * along;
            if (!(change < min)) continue;
            min = change;
            best = to;
        }
    return best;
}

} // namespace qm::check
