#include "check/surfaces/distance.h"

#include "base/at.h"
#include "check/surfaces/bilinear_quad.h"
#include "check/surfaces/distance_model.h"

#include <cmath>
#include <utility>

namespace qm::check {

namespace {

constexpr int iterations = 200;

/// Walks towards the parameters in the box [0, max] whose point is nearest, or to one that is near enough;
/// returns the smallest distance seen.
template <class Surface>
double nearest(const Surface& surface, Parameters at, const Parameters& max, const Place& point,
               double enough) {
    constexpr int maxHalvings = 20;
    int halvings = 0;
    bool bends = false; // so much that steps on the tangents are far too long
    double min = HUGE_VAL;
    Parameters before = at;
    for (int i = 0; i < iterations; ++i) {
        const SurfacePoint here = surface(at);
        const Place away = minus(point, here.point);
        const double now = length(away);
        if (!(now < min)) {
            // The step was too long: half as long, from where it began.
            if (++halvings > maxHalvings) break;
            bends = true;
            at = {(at[0] + before[0]) / 2, (at[1] + before[1]) / 2};
            continue;
        }
        min = now;
        if (min <= enough) break;
        halvings = 0;
        before = at;
        at = minimumOf(bends ? onSurface(surface, here, away, at, max) : onTangents(here, away), at, max);
    }
    return min;
}

} // namespace

double distanceToFace(const CheckedMesh& mesh, int face, Parameters start, const Place& point,
                      double enough) {
    const auto corners = quadOf(mesh, face).corners;
    const Vector alongS = minus(corners[1], corners[0]);
    const Vector alongT = minus(corners[3], corners[0]);
    const Vector twist = minus(minus(corners[2], corners[3]), alongS);
    const auto surface = [&](const Parameters& at) {
        const auto& [s, t] = at;
        SurfacePoint here;
        for (std::size_t k = 0; k < 3; ++k) {
            here.alongU[k] = alongS[k] + t * twist[k];
            here.alongV[k] = alongT[k] + s * twist[k];
            here.point[k] = corners[0][k] + s * here.alongU[k] + t * alongT[k];
        }
        return here;
    };
    return nearest(surface, start, {1, 1}, point, enough);
}

double distanceToPatch(const SurfacesPart::Patch& patch, Parameters parameters, const Place& point,
                       double enough) {
    const auto max = [&](std::size_t k) { return patch.knots[k][at(patch.count[k])]; };
    return nearest([&](const Parameters& at) { return evaluate(patch, at[0], at[1]); }, parameters,
                   {max(0), max(1)}, point, enough);
}

FaceSearch::FaceSearch(const CheckedMesh& mesh, const Neighbourhoods& around,
                       SearchStarts::LatticeOn latticeOn)
    : mesh_(mesh), around_(around), starts_(mesh.quads.size(), std::move(latticeOn)) {}

int FaceSearch::faceBeside(int face, std::size_t side) const {
    const auto& corners = mesh_.quads[at(face)];
    return around_.leftFace(around_.stepBetween(corners[(side + 1) % corners.size()], corners[side]));
}

DistanceToMesh::DistanceToMesh(const CheckedMesh& mesh, const Neighbourhoods& around)
    : mesh_(mesh), search_(mesh, around, [this](std::size_t face, const auto& parameters) {
          const BilinearQuad quad = quadOf(mesh_, static_cast<int>(face));
          std::vector<Place> places;
          for (const double t : parameters)
              for (const double s : parameters)
                  places.push_back(quad.at(s, t));
          return places;
      }) {}

double DistanceToMesh::from(const Place& point, int face, const Parameters& start, double limit,
                            LastFace& last) const {
    return search_.nearest(point, face, start, limit, last, [&](int near, const Parameters& within) {
        return distanceToFace(mesh_, near, within, point, limit);
    });
}

DistanceToSurfaces::DistanceToSurfaces(const CheckedMesh& mesh, const Neighbourhoods& around,
                                       const LayoutPart& layout, const SurfacesPart& part)
    : part_(part), places_(mesh.quads.size()),
      search_(mesh, around, [this](std::size_t face, const auto& parameters) {
          std::vector<double> us;
          std::vector<double> vs;
          for (const double within : parameters) {
              const auto [u, v] = inPatch(face, {within, within});
              us.push_back(u);
              vs.push_back(v);
          }
          std::vector<Place> places;
          for (const SurfacePoint& there : evaluateLattice(part_.patches[places_[face].patch], us, vs))
              places.push_back(there.point);
          return places;
      }) {
    for (std::size_t p = 0; p < layout.segments.size(); ++p) {
        const auto& segment = layout.segments[p];
        for (std::size_t f = 0; f < segment.faces.size(); ++f)
            places_[at(segment.faces[f])] = {p, static_cast<int>(f) % segment.size[0],
                                             static_cast<int>(f) / segment.size[0]};
    }
}

double DistanceToSurfaces::from(const Place& point, int face, const Parameters& within, double limit,
                                LastFace& last) const {
    return search_.nearest(point, face, within, limit, last, [&](int near, const Parameters& parameters) {
        const SurfacesPart::Patch& patch = part_.patches[places_[at(near)].patch];
        return distanceToPatch(patch, inPatch(at(near), parameters), point, limit);
    });
}

Parameters DistanceToSurfaces::inPatch(std::size_t face, const Parameters& within) const {
    return {places_[face].column + within[0], places_[face].row + within[1]};
}

} // namespace qm::check
