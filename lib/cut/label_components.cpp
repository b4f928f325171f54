#include "cut/label_components.h"

namespace qm {

LabelComponents::LabelComponents(const QuadMesh& mesh, const std::vector<SubMeshId>& labels)
    : mesh_(mesh), labels_(labels), connected_(mesh.n_vertices()), component_(mesh.n_vertices(), -1) {}

int LabelComponents::number(const std::vector<VertexId>& vertices) {
    for (const VertexId vertex : vertices)
        connected_.isolate(at(vertex));
    // Vertices are visited in order, which is faster on large meshes than to follow edges.
    for (const VertexId vertex : vertices)
        for (const VertexId next : mesh_.vv_range(vertex))
            if (next.idx() < vertex.idx() && labels_[at(next)] == labels_[at(vertex)])
                connected_.join(at(vertex), at(next));
    int count = 0;
    for (const VertexId vertex : vertices) {
        const std::size_t lowest = connected_.find(at(vertex));
        component_[at(vertex)] = lowest == at(vertex) ? count++ : component_[lowest];
    }
    return count;
}

} // namespace qm
