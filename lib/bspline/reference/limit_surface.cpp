#include "bspline/reference/limit_surface.h"

#include "base/parallel.h"
#include "bspline/reference/control_mesh.h"
#include "bspline/reference/mesh_lattice.h"
#include "bspline/network/vertex_rules.h"

#include <cstddef>

namespace qm {
namespace {

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

MeshLattice limitLattice(const QuadMesh& mesh, const Layout& layout, const std::vector<bool>& isCrease,
                         int steps, unsigned jobs) {
    const std::vector<bool> sharp = creasesAndBoundary(mesh, isCrease);
    const std::vector<VertexRule> rules = vertexRules(mesh, layout, sharp);
    const ControlMesh control = interpolatingControlMesh(mesh, rules);
    MeshLattice lattice(mesh, control.points);
    while (lattice.squares() < steps)
        lattice = lattice.subdivided(rules, sharp, jobs);
    lattice = lattice.limit(rules, sharp, jobs);
    for (const VertexId vertex : mesh.vertices())
        if (control.interpolates[at(vertex.idx())]) lattice.move(vertex, mesh.point(vertex));
    return lattice;
}

/// The part of a lattice that covers a segment.
ReferenceGrid gridOf(const QuadMesh& mesh, const Segment& segment, const MeshLattice& lattice) {
    ReferenceGrid grid{segment.size, lattice.squares()};
    const auto [columns, rows] = segment.size;
    const std::size_t width = at(columns * grid.steps + 1);
    grid.points.resize(width * at(rows * grid.steps + 1));
    const std::vector<VertexId> vertices = vertexGrid(mesh, segment);
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            HalfedgeId halfedge = mesh.halfedge_handle(segment.faces[at(j * columns + i)]);
            while (mesh.from_vertex_handle(halfedge) != vertices[at(j * (columns + 1) + i)])
                halfedge = mesh.next_halfedge_handle(halfedge);
            Point* corner = grid.points.data() + at(j * grid.steps) * width + at(i * grid.steps);
            for (int depth = 0; depth <= grid.steps; ++depth)
                for (int along = 0; along <= grid.steps; ++along)
                    corner[at(depth) * width + at(along)] = lattice.at(halfedge, along, depth);
        }
    return grid;
}

} // namespace

std::vector<ReferenceGrid> limitSurface(const QuadMesh& mesh, const Layout& layout,
                                        const std::vector<bool>& isCrease, int steps, unsigned jobs) {
    const MeshLattice lattice = limitLattice(mesh, layout, isCrease, steps, jobs);
    std::vector<ReferenceGrid> grids(layout.segments.size());
    parallelFor(grids.size(), jobs,
                [&](std::size_t k) { grids[k] = gridOf(mesh, layout.segments[k], lattice); });
    return grids;
}

} // namespace qm
