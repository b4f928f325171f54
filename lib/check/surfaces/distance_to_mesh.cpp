#include "check/surfaces/distance_to_mesh.h"

#include "check/surfaces/bilinear_quad.h"

#include <algorithm>

namespace qm::check {

DistanceToMesh::DistanceToMesh(const CheckedMesh& mesh)
    : mesh_(mesh), starts_(mesh.quads.size(), [this](std::size_t face, const Parameters& parameters) {
          return quadOf(mesh_, static_cast<int>(face)).at(parameters[0], parameters[1]);
      }) {}

double DistanceToMesh::from(const Place& point, int face, const Parameters& start, double limit) const {
    double nearest = distanceToFace(mesh_, face, start, point, limit);
    if (nearest <= limit) return nearest;
    for (const Start& other : starts_.within(nearest, point)) {
        if (other.distance - other.reach > nearest) continue;
        nearest = std::min(
            nearest, distanceToFace(mesh_, static_cast<int>(other.part), other.parameters, point, limit));
        if (nearest <= limit) break;
    }
    return nearest;
}

} // namespace qm::check
