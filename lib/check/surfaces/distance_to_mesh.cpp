#include "check/surfaces/distance_to_mesh.h"

#include "check/surfaces/bilinear_quad.h"

namespace qm::check {

DistanceToMesh::DistanceToMesh(const CheckedMesh& mesh)
    : mesh_(mesh), starts_(mesh.quads.size(), [this](std::size_t face, const Parameters& parameters) {
          return quadOf(mesh_, static_cast<int>(face)).at(parameters[0], parameters[1]);
      }) {}

double DistanceToMesh::from(const Place& point, int face, const Parameters& start, double limit) const {
    const double first = distanceToFace(mesh_, face, start, point, limit);
    if (first <= limit) return first;
    return starts_.nearest(point, first, limit, [&](const Start& other) {
        return distanceToFace(mesh_, static_cast<int>(other.part), other.parameters, point, limit);
    });
}

} // namespace qm::check
