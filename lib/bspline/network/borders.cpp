#include "bspline/network/borders.h"

#include "base/at.h"
#include "base/error.h"

#include <string>

namespace qm {
namespace {

HalfedgeId halfedgeInFace(const QuadMesh& mesh, FaceId face, VertexId from, VertexId to) {
    HalfedgeId halfedge = mesh.halfedge_handle(face);
    for (int k = 0; k < 4; ++k, halfedge = mesh.next_halfedge_handle(halfedge))
        if (mesh.from_vertex_handle(halfedge) == from && mesh.to_vertex_handle(halfedge) == to)
            return halfedge;
    throw Error("face " + std::to_string(face.idx()),
                "has no edge from vertex " + std::to_string(from.idx()) + " to " + std::to_string(to.idx()) +
                    " on the side of its segment",
                "Make the layout anew");
}

} // namespace

std::size_t faceBeside(const Segment& segment, int side, int position) {
    const int a = segment.size[0];
    const int b = segment.size[1];
    int column = 0;
    int row = 0;
    switch (side) {
    case 0:
        column = position;
        break;
    case 1:
        column = a - 1;
        row = position;
        break;
    case 2:
        column = a - 1 - position;
        row = b - 1;
        break;
    default:
        row = b - 1 - position;
    }
    return at(row) * at(a) + at(column);
}

std::array<double, 2> parametersOnSide(const std::array<int, 2>& size, int side, double along) {
    switch (side) {
    case 0:
        return {along, 0};
    case 1:
        return {static_cast<double>(size[0]), along};
    case 2:
        return {size[0] - along, static_cast<double>(size[1])};
    default:
        return {0, size[1] - along};
    }
}

std::vector<BorderEdge> borderEdges(const QuadMesh& mesh, const Layout& layout) {
    std::vector<BorderEdge> borders;
    std::vector<std::ptrdiff_t> ofEdge(mesh.n_edges(), -1);
    for (std::size_t s = 0; s < layout.segments.size(); ++s) {
        const Segment& segment = layout.segments[s];
        for (int side = 0; side < 4; ++side) {
            const auto& vertices = segment.sides[at(side)];
            for (std::size_t k = 0; k + 1 < vertices.size(); ++k) {
                const int position = static_cast<int>(k);
                const FaceId face = segment.faces[faceBeside(segment, side, position)];
                const HalfedgeId halfedge = halfedgeInFace(mesh, face, vertices[k], vertices[k + 1]);
                auto& index = ofEdge[at(mesh.edge_handle(halfedge))];
                if (index < 0) {
                    index = static_cast<std::ptrdiff_t>(borders.size());
                    borders.push_back({halfedge, {}});
                }
                borders[at(index)].places.push_back({s, side, position});
            }
        }
    }
    return borders;
}

} // namespace qm
