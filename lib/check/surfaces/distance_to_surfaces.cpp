#include "check/surfaces/distance_to_surfaces.h"

#include "base/at.h"
#include "base/infinity.h"
#include "check/surfaces/spline.h"

#include <algorithm>

namespace qm::check {

DistanceToSurfaces::DistanceToSurfaces(const Context& context, const LayoutPart& layout,
                                       const SurfacesPart& part)
    : mesh_(context.mesh), around_(context.around), part_(part), places_(context.mesh.quads.size()) {
    for (std::size_t p = 0; p < layout.segments.size(); ++p) {
        const auto& segment = layout.segments[p];
        for (std::size_t f = 0; f < segment.faces.size(); ++f)
            places_[at(segment.faces[f])] = {p, static_cast<int>(f) % segment.size[0],
                                             static_cast<int>(f) / segment.size[0]};
    }
}

double DistanceToSurfaces::distanceFrom(const Place& point, int face, std::size_t patch,
                                        const Parameters& parameters, double limit) const {
    double nearest = distanceToPatch(part_.patches[patch], parameters, point, limit);
    if (nearest <= limit) return nearest;
    for (const int vertex : mesh_.quads[at(face)])
        for (int k = 0; k < around_.valence(vertex); ++k) {
            const int other = around_.leftFace(around_.firstStep(vertex) + k);
            if (other < 0) continue;
            nearest = std::min(nearest, distanceToPart(places_[at(other)], point, 2, limit));
            if (nearest <= limit) return nearest;
        }
    return distanceToAll(point, limit, nearest);
}

/// To the surface over a face, or where the search leads to from a lattice of places there: where it is
/// folded, many points are nearer than all around them.
double DistanceToSurfaces::distanceToPart(const FacePlace& place, const Place& point, int steps,
                                          double enough) const {
    double nearest = infinity;
    for (int i = 0; i <= steps; ++i)
        for (int j = 0; j <= steps; ++j) {
            const Parameters start{place.column + static_cast<double>(i) / steps,
                                   place.row + static_cast<double>(j) / steps};
            nearest = std::min(nearest, distanceToPatch(part_.patches[place.patch], start, point, enough));
            if (nearest <= enough) return nearest;
        }
    return nearest;
}

/// From all faces whose part of the surface may be nearer than what was found: a reference of another
/// shape draws surfaces away from their faces.
double DistanceToSurfaces::distanceToAll(const Place& point, double limit, double nearest) const {
    for (const FacePlace& place : places_) {
        const SurfacesPart::Patch& patch = part_.patches[place.patch];
        const auto corner = [&](double s, double t) {
            return evaluate(patch, place.column + s, place.row + t).point;
        };
        const Place middle = corner(0.5, 0.5);
        double radius = 0;
        for (const Parameters& end : {Parameters{0, 0}, {1, 0}, {1, 1}, {0, 1}})
            radius = std::max(radius, distance(middle, corner(end[0], end[1])));
        constexpr double bulge = 1.5;
        if (distance(middle, point) - bulge * radius > nearest) continue;
        nearest = std::min(nearest, distanceToPart(place, point, 4, limit));
        if (nearest <= limit) break;
    }
    return nearest;
}

} // namespace qm::check
