#include "export/quads.h"

#include "base/at.h"
#include "base/bytes.h"
#include "base/number_text.h"
#include "mesh/quad_geometry.h"

#include <cstdint>

namespace qm {
std::string quadsAsObj(const QuadMesh& mesh, const Layout& layout) {
    std::string text;
    for (const VertexId vertex : mesh.vertices()) {
        text += 'v';
        for (const double coordinate : mesh.point(vertex)) {
            appendNumber(text += ' ', coordinate);
        }
        text += '\n';
    }
    for (std::size_t s = 0; s < layout.segments.size(); ++s) {
        text += "g segment_";
        appendNumber(text, s);
        text += '\n';
        for (const FaceId face : layout.segments[s].faces) {
            text += 'f';
            for (const VertexId vertex : cornersOf(mesh, face)) {
                appendNumber(text += ' ', vertex.idx() + 1);
            }
            text += '\n';
        }
    }
    return text;
}

std::string quadsAsPly(const QuadMesh& mesh, const Layout& layout, const std::vector<Colour>& colours) {
    std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex ";
    appendNumber(bytes, mesh.n_vertices());
    bytes += "\nproperty double x\nproperty double y\nproperty double z\nelement face ";
    appendNumber(bytes, mesh.n_faces());
    bytes += "\nproperty list uchar int vertex_indices\nproperty uchar red\nproperty uchar green\n"
             "property uchar blue\nproperty int segment\nend_header\n";
    for (const VertexId vertex : mesh.vertices())
        for (const double coordinate : mesh.point(vertex))
            appendBytes(bytes, coordinate);

    std::vector<std::size_t> segmentOf(mesh.n_faces(), 0);
    for (std::size_t s = 0; s < layout.segments.size(); ++s)
        for (const FaceId face : layout.segments[s].faces)
            segmentOf[at(face)] = s;
    for (const FaceId face : mesh.faces()) {
        const std::size_t segment = segmentOf[at(face)];
        appendBytes(bytes, std::uint8_t{4});
        for (const VertexId vertex : cornersOf(mesh, face))
            appendBytes(bytes, static_cast<std::int32_t>(vertex.idx()));
        for (const std::uint8_t part : colours[segment])
            appendBytes(bytes, part);
        appendBytes(bytes, static_cast<std::int32_t>(segment));
    }
    return bytes;
}

} // namespace qm
