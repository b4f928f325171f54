#include "layout/constraints.h"

#include "layout/borders.h"

#include <algorithm>

namespace qm {

bool obeyConstraints(const QuadMesh& mesh, std::span<const Track> tracks, const Constraints& constraints) {
    const Borders borders(mesh, tracks);
    return std::ranges::all_of(constraints.required, [&](EdgeId edge) { return borders.isBorder(edge); }) &&
           std::ranges::all_of(constraints.forbidden, [&](EdgeId edge) {
               return !borders.isBorder(edge) || mesh.is_boundary(edge);
           });
}

} // namespace qm
