#include "mesh/build_mesh.h"

#include "base/error.h"
#include "mesh/validate.h"

namespace qm {

QuadMesh buildMesh(const Soup& soup) {
    validateSoup(soup);
    QuadMesh mesh;
    mesh.reserve(soup.points.size(), soup.corners.size() / 2 + 1, soup.faceCount());
    for (const Point& point : soup.points)
        mesh.add_vertex(point);
    std::vector<VertexId> corners(4);
    for (std::size_t k = 0; k < soup.faceCount(); ++k) {
        for (std::size_t i = 0; i < 4; ++i)
            corners[i] = VertexId(static_cast<int>(soup.face(k)[i]));
        if (!mesh.add_face(corners).is_valid())
            throw Error(soup.facePlace(k), "it does not fit the faces before it",
                        "the surface is no manifold there");
    }
    return mesh;
}

QuadMesh buildMesh(const std::vector<Point>& points, const std::vector<std::array<int, 4>>& quads) {
    Soup soup;
    soup.points = points;
    for (const auto& quad : quads) {
        soup.corners.insert(soup.corners.end(), quad.begin(), quad.end());
        soup.endFace(0);
    }
    return buildMesh(soup);
}

} // namespace qm
