#include "base/parallel.h"
#include "bspline/deviation.h"
#include "bspline/deviation_samples.h"
#include "bspline/patch_distance.h"

#include <algorithm>

namespace qm {
namespace {

/// The angle between the quads on both sides of an edge, at a share of it: bilinear quads turn along an edge,
/// and fold at a corner that is concave.
double kinkOfQuads(const QuadMesh& mesh, HalfedgeId halfedge, double along) {
    const auto normal = [&](HalfedgeId h, double share) {
        const Point& start = mesh.point(mesh.from_vertex_handle(h));
        const Point& end = mesh.point(mesh.to_vertex_handle(h));
        const Point atStart = mesh.point(mesh.from_vertex_handle(mesh.prev_halfedge_handle(h))) - start;
        const Point atEnd = mesh.point(mesh.to_vertex_handle(mesh.next_halfedge_handle(h))) - end;
        return unitNormal(end - start, (1 - share) * atStart + share * atEnd);
    };
    return angleInDegrees(normal(halfedge, along),
                          normal(mesh.opposite_halfedge_handle(halfedge), 1 - along));
}

/// Where the surface is too far from the mesh. What is near the point with its parameters is near enough.
void findFar(const Patch& patch, const QuadGrid& quads, const MeshDistance& mesh, int samplesPerEdge,
             double farthest, std::vector<DeviatingPlace>& places) {
    visitLattice(
        patch, quads, samplesPerEdge, [&](double u, double v, const SurfacePoint& on, const Point& of) {
            const double bound = (on.position - of).norm();
            if (bound <= farthest) return;
            const double distance = std::max(mesh(on.position, bound), distanceToPatch(patch, of, u, v, on));
            if (!(distance <= farthest)) places.push_back({{u, v}, distance});
        });
}

void findBent(const Patch& patch, const QuadGrid& quads, double mostBent,
              std::vector<DeviatingPlace>& places) {
    const std::vector<double> angles = normalDeviations(patch, quads);
    const auto columns = static_cast<std::size_t>(quads.size()[0]);
    for (std::size_t k = 0; k < angles.size(); ++k)
        if (angles[k] > mostBent)
            places.push_back(
                {{static_cast<double>(k % columns) + 0.5, static_cast<double>(k / columns) + 0.5}, 0});
}

} // namespace

DeviatingPlaces DeviationMeter::find(const std::vector<Patch>& patches, const DeviationLimits& limits,
                                     const std::vector<bool>& only, const Control& control) const {
    const auto counts = [&](std::size_t patch) { return only.empty() || only[patch]; };
    DeviatingPlaces places(patches.size());
    parallelFor(patches.size(), control.jobs, [&](std::size_t k) {
        if (!counts(k)) return;
        const QuadGrid grid = quads(k);
        findFar(patches[k], grid, distance_, options_.samplesPerEdge, limits.farthest, places[k]);
        findBent(patches[k], grid, limits.mostBent, places[k]);
    });
    std::vector<std::vector<double>> kinked(borders_.size()); // shares of the edge
    parallelFor(borders_.size(), control.jobs, [&](std::size_t k) {
        const BorderEdge& border = borders_[k];
        if (border.places.size() != 2 || !isSmooth(border) ||
            std::ranges::none_of(border.places, counts, &BorderPlace::patch))
            return;
        for (const double along : kinkSamples)
            if (kink(meeting(border, layout_, patches, along)) > limits.mostKinked &&
                kinkOfQuads(mesh_, border.halfedge, along) < limits.mostKinked)
                kinked[k].push_back(along);
    });
    for (std::size_t k = 0; k < borders_.size(); ++k)
        for (const double along : kinked[k])
            for (const std::size_t side : {0U, 1U})
                places[borders_[k].places[side].patch].push_back(
                    {parametersAt(borders_[k], side, layout_, along), 0});
    return places;
}

} // namespace qm
