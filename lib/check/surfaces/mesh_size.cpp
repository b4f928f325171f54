#include "check/surfaces/mesh_size.h"

#include "base/at.h"
#include "check/mesh/vectors.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace qm::check {

double boundingBoxDiagonal(const CheckedMesh& mesh) {
    Place low{HUGE_VAL, HUGE_VAL, HUGE_VAL};
    Place high{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    for (const auto& quad : mesh.quads)
        for (const int vertex : quad)
            for (std::size_t k = 0; k < 3; ++k) {
                low[k] = std::min(low[k], mesh.points[at(vertex)][k]);
                high[k] = std::max(high[k], mesh.points[at(vertex)][k]);
            }
    return mesh.quads.empty() ? 0 : distance(low, high);
}

double samePlace(const CheckedMesh& mesh) {
    constexpr double share = 1e-9;
    constexpr double roundings = 16 * std::numeric_limits<double>::epsilon(); // of a sum of 16 control points
    return share * boundingBoxDiagonal(mesh) + roundings * largestCoordinate(mesh.points);
}

} // namespace qm::check
