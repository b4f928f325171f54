#include "bspline/reference/limit/limit_surface.h"

#include "base/parallel.h"
#include "bspline/reference/bending/min_bending.h"
#include "bspline/reference/lattice/mesh_lattice.h"
#include "bspline/reference/limit/control_mesh.h"
#include "bspline/reference/limit/even_poles.h"
#include "bspline/reference/limit/even_speeds.h"
#include "bspline/reference/limit/through_vertices.h"
#include "bspline/reference/limit/unfolded_lattice.h"
#include "bspline/reference/planes/in_planes.h"
#include "bspline/reference/planes/plane_corners.h"
#include "mesh/bounding_box.h"

#include <cstddef>

namespace qm {
namespace {

constexpr FoldLimits ofLimit{.minArea = 0.3, .minAreaAtPoint = 0.1};
/// `evenSpeeds` makes derivatives shorter on purpose, beside edges that are much shorter down to a twentieth.
constexpr FoldLimits afterEvening{.minArea = 0.15, .minAreaAtPoint = 0.1, .minSpeed = 0.02};

MeshLattice limitLattice(const QuadMesh& mesh, const Sharpness& sharpness, int steps, unsigned jobs) {
    const auto& [rules, sharp] = sharpness;
    const ControlMesh control = interpolatingControlMesh(mesh, rules);
    MeshLattice lattice(mesh, control.points);
    while (lattice.squares() < steps)
        lattice = lattice.subdivided(sharpness, jobs);
    lattice = lattice.limit(sharpness, jobs);
    drawThroughVertices(lattice, control.interpolates, jobs);
    unfold(lattice, sharpness, nullptr, ofLimit, jobs);
    const PlaneCorners corners(lattice, sharpness, maxFlatness * boundingBox(mesh).diagonal(), jobs);
    layInPlanes(lattice, corners, sharp, jobs);
    evenSpeeds(lattice, sharpness, corners, jobs);
    evenPoles(lattice, rules, jobs);
    minimiseBending(lattice, rules, corners, jobs);
    unfold(lattice, sharpness, &corners, afterEvening, jobs);
    return lattice;
}

/// The part of a lattice that covers a segment.
ReferenceGrid gridOf(const Segment& segment, const MeshLattice& lattice) {
    ReferenceGrid grid{segment.size, lattice.squares()};
    const std::vector<std::size_t> numbers = lattice.numbers().ofSegment(segment);
    grid.points.reserve(numbers.size());
    for (const std::size_t number : numbers)
        grid.points.push_back(lattice.point(number));
    return grid;
}

} // namespace

std::vector<ReferenceGrid> limitSurface(const QuadMesh& mesh, const Layout& layout,
                                        const Sharpness& sharpness, int steps, unsigned jobs) {
    const MeshLattice lattice = limitLattice(mesh, sharpness, steps, jobs);
    std::vector<ReferenceGrid> grids(layout.segments.size());
    parallelFor(grids.size(), jobs, [&](std::size_t k) { grids[k] = gridOf(layout.segments[k], lattice); });
    return grids;
}

} // namespace qm
