#include "mesh/write_mesh.h"

#include "base/number_text.h"
#include "mesh/quad_geometry.h"

namespace qm {
std::string writeObj(const QuadMesh& mesh) {
    std::string text;
    text.reserve(mesh.n_vertices() * 60 + mesh.n_faces() * 30);
    for (const VertexId vertex : mesh.vertices()) {
        text += 'v';
        for (const double value : mesh.point(vertex))
            appendNumber(text += ' ', value);
        text += '\n';
    }
    for (const FaceId face : mesh.faces()) {
        text += 'f';
        for (const VertexId corner : cornersOf(mesh, face))
            appendNumber(text += ' ', corner.idx() + 1);
        text += '\n';
    }
    return text;
}

} // namespace qm
