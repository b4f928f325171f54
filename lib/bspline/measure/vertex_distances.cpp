#include "bspline/measure/vertex_distances.h"

#include "base/at.h"
#include "base/parallel.h"
#include "bspline/measure/foot_search.h"
#include "bspline/splines/eigen_point.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <mutex>

namespace qm {
namespace {

/// Calls a function with every vertex of a segment's grid and its parameters, row by row.
template <class Function>
void forGrid(const QuadMesh& mesh, const Segment& segment, const Function& function) {
    const std::vector<VertexId> grid = vertexGrid(mesh, segment);
    const std::size_t columns = at(segment.size[0]) + 1;
    for (std::size_t k = 0; k < grid.size(); ++k) {
        const std::size_t column = k % columns;
        const std::size_t row = k / columns;
        function(grid[k], std::array{static_cast<double>(column), static_cast<double>(row)});
    }
}

/// By vertex: its place in one of its patches.
std::vector<LayoutPlace> placesOfVertices(const QuadMesh& mesh, const Layout& layout) {
    std::vector<LayoutPlace> places(mesh.n_vertices());
    for (std::size_t k = 0; k < layout.segments.size(); ++k)
        forGrid(mesh, layout.segments[k], [&](VertexId vertex, const std::array<double, 2>& parameters) {
            places[at(vertex)] = {k, parameters};
        });
    return places;
}

/// Finds what a search from the vertex's own place may miss, as it crosses few borders: it goes from vertex
/// to vertex to the one whose place is the nearest, and searches from there.
double distanceFromAfar(const QuadMesh& mesh, const std::vector<LayoutPlace>& places, VertexId vertex,
                        FootSearch& search) {
    const Eigen::Vector3d point = vector(mesh.point(vertex));
    const auto distanceAt = [&](VertexId other) {
        return (search.evaluateAt(0, places[at(other)]).position - point).norm();
    };
    VertexId nearest = vertex;
    double distance = distanceAt(vertex);
    for (VertexId from; from != nearest;) {
        from = nearest;
        for (const FaceId face : mesh.vf_range(from))
            for (const VertexId other : mesh.fv_range(face)) {
                const double ofOther = distanceAt(other);
                if (!(ofOther < distance)) continue;
                distance = ofOther;
                nearest = other;
            }
    }
    return search(0, places[at(nearest)], point).distance;
}

} // namespace

std::vector<Samples> vertexDistances(const QuadMesh& mesh, const Layout& layout,
                                     const PairedSurfaces& toReference,
                                     const std::vector<double>& ofReference, unsigned jobs) {
    std::vector<Samples> distances(layout.segments.size());
    std::vector<LayoutPlace> places; // few meshes need them
    std::once_flag havePlaces;
    parallelFor(distances.size(), jobs, [&](std::size_t k) {
        FootSearch search(toReference);
        forGrid(mesh, layout.segments[k], [&](VertexId vertex, const std::array<double, 2>& parameters) {
            const LayoutPlace place{k, parameters};
            const Eigen::Vector3d point = vector(mesh.point(vertex));
            double distance = search(0, place, point).distance;
            if (distance > ofReference[k]) {
                std::call_once(havePlaces, [&] { places = placesOfVertices(mesh, layout); });
                distance = std::min(distance, distanceFromAfar(mesh, places, vertex, search));
            }
            // Where surfaces fold, both may miss the nearest place; but no distance is more than that of the
            // reference and that from there.
            if (distance > ofReference[k]) {
                const double fromHere = (search.evaluateAt(1, place).position - point).norm();
                distance = std::min(distance, fromHere + ofReference[k]);
            }
            distances[k].push_back({distance});
        });
    });
    return distances;
}

} // namespace qm
