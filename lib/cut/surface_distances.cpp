#include "cut/surface_distances.h"

#include "base/at.h"
#include "base/infinity.h"
#include "base/sort_unique.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace qm {
namespace {

constexpr int unknown = std::numeric_limits<int>::max();

/// The radius of a cell, in edges. Small sub-meshes take little time as they are. Large ones are divided into
/// about 5,000 cells, however large they are: in a grid of quads, cells of this radius have about
/// 3/4 (radius + 1)^2 vertices.
int radiusFor(std::size_t vertices) {
    constexpr std::size_t maxFine = 16000;
    constexpr double wantedCells = 5000, share = 0.75;
    if (vertices <= maxFine) return 0;
    const double wanted = static_cast<double>(vertices) / (share * wantedCells);
    return std::max(1, static_cast<int>(std::lround(std::sqrt(wanted))) - 1);
}

} // namespace

SurfaceDistances::SurfaceDistances(const QuadMesh& mesh, const std::vector<SubMeshId>& labels)
    : mesh_(mesh), labels_(labels), steps_(mesh.n_vertices(), unknown), cellOf_(mesh.n_vertices(), 0) {}

void SurfaceDistances::prepare(const std::vector<VertexId>& vertices) {
    prepare(vertices, radiusFor(vertices.size()));
}

void SurfaceDistances::prepare(const std::vector<VertexId>& vertices, int radius) {
    makeCells(vertices, radius);
    const std::vector<CellTie> ties = tiesOf(vertices);
    // The front itself finds the distances of single vertices from their neighbours.
    findNeighbours(radius > 0 ? ties : std::vector<CellTie>{});
    std::vector<Point> points;
    points.reserve(centres_.size());
    for (const VertexId centre : centres_)
        points.push_back(mesh_.point(centre));
    front_.emplace(points, ties);
}

/// Every vertex that no cell has reached becomes a centre, and takes all vertices that are nearer to it than
/// to earlier centres.
void SurfaceDistances::makeCells(const std::vector<VertexId>& vertices, int radius) {
    centres_.clear();
    for (const VertexId vertex : vertices)
        steps_[at(vertex)] = unknown;
    for (const VertexId vertex : vertices)
        if (steps_[at(vertex)] == unknown) growCell(vertex, radius);
}

void SurfaceDistances::growCell(VertexId centre, int radius) {
    const int cell = static_cast<int>(centres_.size());
    centres_.push_back(centre);
    steps_[at(centre)] = 0;
    cellOf(centre) = cell;
    std::vector<VertexId> reached{centre};
    for (std::size_t next = 0; next < reached.size(); ++next) {
        const VertexId vertex = reached[next];
        const int steps = steps_[at(vertex)] + 1;
        if (steps > radius) break;
        for (const VertexId other : mesh_.vv_range(vertex)) {
            if (steps_[at(other)] <= steps || labels_[at(other)] != labels_[at(centre)]) continue;
            steps_[at(other)] = steps;
            cellOf(other) = cell;
            reached.push_back(other);
        }
    }
}

/// The ties of all quads that have corners in several cells, each once, ascending. Corners outside the
/// sub-mesh do not count.
std::vector<SurfaceDistances::CellTie> SurfaceDistances::tiesOf(const std::vector<VertexId>& vertices) const {
    std::vector<CellTie> ties;
    for (const VertexId vertex : vertices)
        for (const HalfedgeId halfedge : mesh_.voh_range(vertex))
            if (!mesh_.is_boundary(halfedge))
                if (const auto tie = tieOf(halfedge)) ties.push_back(*tie);
    sortUnique(ties);
    return ties;
}

/// The tie of a quad whose lowest corner in the sub-mesh is the one that the halfedge leaves.
std::optional<SurfaceDistances::CellTie> SurfaceDistances::tieOf(HalfedgeId halfedge) const {
    const VertexId vertex = mesh_.from_vertex_handle(halfedge);
    CellTie tie{cellOf_[at(vertex)]};
    std::size_t count = 1;
    for (int k = 1; k < 4; ++k) {
        const VertexId corner = mesh_.to_vertex_handle(halfedge);
        halfedge = mesh_.next_halfedge_handle(halfedge);
        if (labels_[at(corner)] != labels_[at(vertex)]) continue;
        if (corner.idx() < vertex.idx()) return std::nullopt;
        const int cell = cellOf_[at(corner)];
        if (std::find(tie.begin(), tie.begin() + count, cell) == tie.begin() + count) tie[count++] = cell;
    }
    if (count < 2) return std::nullopt;
    std::rotate(tie.begin(), std::min_element(tie.begin(), tie.begin() + count), tie.begin() + count);
    std::fill(tie.begin() + count, tie.end(), tie[count - 1]);
    return tie;
}

void SurfaceDistances::findNeighbours(const std::vector<CellTie>& ties) {
    around_.assign(centres_.size(), {});
    for (std::size_t cell = 0; cell < around_.size(); ++cell)
        around_[cell].push_back(static_cast<int>(cell));
    for (const CellTie& tie : ties)
        for (const int cell : tie)
            around_[at(cell)].insert(around_[at(cell)].end(), tie.begin(), tie.end());
    for (std::vector<int>& cells : around_)
        sortUnique(cells);
}

double SurfaceDistances::length(VertexId vertex, int cell) const {
    return (mesh_.point(vertex) - mesh_.point(centres_[at(cell)])).norm();
}

std::vector<double> SurfaceDistances::between(VertexId source, const std::vector<VertexId>& targets) {
    const std::vector<int>& near = around_[at(cellOf(source))];
    std::vector<Geodesics::Start> starts;
    starts.reserve(near.size());
    for (const int cell : near)
        starts.push_back({cell, length(source, cell)});
    const std::vector<double>& toCentres = front_->from(starts);
    std::vector<double> distances;
    distances.reserve(targets.size());
    for (const VertexId target : targets) {
        const int own = cellOf(target);
        double nearest = infinity;
        if (std::ranges::binary_search(near, own))
            nearest = (mesh_.point(target) - mesh_.point(source)).norm();
        for (const int cell : around_[at(own)])
            if (toCentres[at(cell)] < nearest)
                nearest = std::min(nearest, toCentres[at(cell)] + length(target, cell));
        distances.push_back(nearest);
    }
    return distances;
}

} // namespace qm
