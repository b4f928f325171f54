#include "mesh/write_mesh.h"

#include "mesh/quad_geometry.h"

#include <array>
#include <charconv>

namespace qm {
namespace {

template <class Number> void append(std::string& text, Number value) {
    std::array<char, 32> buffer;
    text += ' ';
    text.append(buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr);
}

} // namespace

std::string writeObj(const QuadMesh& mesh) {
    std::string text;
    text.reserve(mesh.n_vertices() * 60 + mesh.n_faces() * 30);
    for (const VertexId vertex : mesh.vertices()) {
        text += 'v';
        for (const double value : mesh.point(vertex))
            append(text, value);
        text += '\n';
    }
    for (const FaceId face : mesh.faces()) {
        text += 'f';
        for (const VertexId corner : cornersOf(mesh, face))
            append(text, corner.idx() + 1);
        text += '\n';
    }
    return text;
}

} // namespace qm
