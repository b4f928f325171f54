#include "check/surfaces/distance_to_surfaces.h"

#include "base/at.h"
#include "check/surfaces/spline.h"

namespace qm::check {

DistanceToSurfaces::DistanceToSurfaces(const CheckedMesh& mesh, const LayoutPart& layout,
                                       const SurfacesPart& part)
    : part_(part), places_(mesh.quads.size()),
      starts_(mesh.quads.size(), [this](std::size_t face, const Parameters& within) {
          const auto [u, v] = inPatch(face, within);
          return evaluate(part_.patches[places_[face].patch], u, v).point;
      }) {
    for (std::size_t p = 0; p < layout.segments.size(); ++p) {
        const auto& segment = layout.segments[p];
        for (std::size_t f = 0; f < segment.faces.size(); ++f)
            places_[at(segment.faces[f])] = {p, static_cast<int>(f) % segment.size[0],
                                             static_cast<int>(f) / segment.size[0]};
    }
}

double DistanceToSurfaces::from(const Place& point, std::size_t patch, const Parameters& parameters,
                                double limit) const {
    const double first = distanceToPatch(part_.patches[patch], parameters, point, limit);
    if (first <= limit) return first;
    return starts_.nearest(point, first, limit, [&](const Start& start) {
        return distanceToPatch(part_.patches[places_[start.part].patch],
                               inPatch(start.part, start.parameters), point, limit);
    });
}

Parameters DistanceToSurfaces::inPatch(std::size_t face, const Parameters& within) const {
    return {places_[face].column + within[0], places_[face].row + within[1]};
}

} // namespace qm::check
