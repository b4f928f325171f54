#include "cut/fine_geodesics.h"

#include "base/at.h"
#include "cut/cell_ties.h"

namespace qm {

FineGeodesics::FineGeodesics(const QuadMesh& mesh, const std::vector<SubMeshId>& labels)
    : mesh_(mesh), labels_(labels), indexOf_(mesh.n_vertices(), 0) {}

void FineGeodesics::prepare(const std::vector<VertexId>& vertices) {
    std::vector<Point> points;
    points.reserve(vertices.size());
    for (const VertexId vertex : vertices) {
        indexOf_[at(vertex)] = static_cast<int>(points.size());
        points.push_back(mesh_.point(vertex));
    }
    front_.emplace(points, cellTies(mesh_, labels_, vertices, indexOf_));
}

std::vector<double> FineGeodesics::between(VertexId source, const std::vector<VertexId>& targets) {
    const std::vector<double>& all = front_->from(indexOf_[at(source)]);
    std::vector<double> distances;
    distances.reserve(targets.size());
    for (const VertexId target : targets)
        distances.push_back(all[at(indexOf_[at(target)])]);
    return distances;
}

} // namespace qm
