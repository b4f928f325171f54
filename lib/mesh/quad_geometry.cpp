#include "mesh/quad_geometry.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace qm {
namespace {

/// The vector, multiplied by a power of two if its fourth power would overflow or underflow; this is exact.
Point scaled(const Point& vector) {
    constexpr double small = 1e-70, large = 1e70;
    const double size = std::max({std::abs(vector[0]), std::abs(vector[1]), std::abs(vector[2])});
    if ((size >= small && size <= large) || size == 0) return vector;
    const int exponent = -std::ilogb(size);
    return {std::scalbn(vector[0], exponent), std::scalbn(vector[1], exponent),
            std::scalbn(vector[2], exponent)};
}

/// The vector scaled to unit length; none for a vector of length zero.
std::optional<Point> unit(const Point& vector) {
    const Point direction = scaled(vector);
    const double length = direction.norm();
    return length > 0 ? std::optional(direction / length) : std::nullopt;
}

/// A vector along the normal of a triangle; zero for a triangle without area.
Point crossProduct(const Triangle& triangle) {
    const auto& [a, b, c] = triangle;
    return scaled(b - a) % scaled(c - a);
}

/// Of a quad's corner, seen along the normal in its middle.
struct Angle {
    double sine = 0;
    double cosine = 0;
};

/// In the order of `cornersOf`; those beside an edge without length are 0. None if there is no normal.
std::optional<std::array<Angle, 4>> cornerAngles(const QuadMesh& mesh, FaceId face) {
    const std::optional<Point> normal = middleNormal(mesh, face);
    if (!normal) return std::nullopt;
    const auto points = cornerPoints(mesh, face);
    std::array<Angle, 4> angles;
    for (std::size_t k = 0; k < 4; ++k) {
        const Point onward = scaled(points[(k + 1) % 4] - points[k]);
        const Point back = scaled(points[(k + 3) % 4] - points[k]);
        const double lengths = onward.norm() * back.norm();
        if (lengths > 0) angles[k] = {((onward % back) | *normal) / lengths, (onward | back) / lengths};
    }
    return angles;
}

/// Below this a corner is folded. Where many edges leave a vertex, the angles between them are narrow, and
/// are believed down to a quarter of what they are in a regular spread.
double minSine(const QuadMesh& mesh, VertexId corner, const Angle& angle) {
    constexpr double ofAll = 0.1;
    constexpr double share = 0.25;
    if (angle.cosine < 0) return ofAll;
    return std::min(ofAll, share * 2 * std::numbers::pi / mesh.valence(corner));
}

} // namespace

std::array<VertexId, 4> cornersOf(const QuadMesh& mesh, FaceId face) {
    std::array<VertexId, 4> corners;
    HalfedgeId halfedge = mesh.halfedge_handle(face); // whose target is the face's first vertex
    for (VertexId& corner : corners) {
        corner = mesh.to_vertex_handle(halfedge);
        halfedge = mesh.next_halfedge_handle(halfedge);
    }
    return corners;
}

std::array<Point, 4> cornerPoints(const QuadMesh& mesh, FaceId face) {
    std::array<Point, 4> points;
    std::ranges::transform(cornersOf(mesh, face), points.begin(),
                           [&](VertexId vertex) { return mesh.point(vertex); });
    return points;
}

std::optional<Point> triangleNormal(const Triangle& triangle) {
    return unit(crossProduct(triangle));
}

std::array<Triangle, 2> halvesOf(const QuadMesh& mesh, FaceId face) {
    const auto [a, b, c, d] = cornerPoints(mesh, face);
    return {{{a, b, c}, {a, c, d}}};
}

bool hasArea(const QuadMesh& mesh, FaceId face) {
    return std::ranges::any_of(halvesOf(mesh, face), [](const Triangle& triangle) {
        return crossProduct(triangle) != Point(0, 0, 0);
    });
}

std::optional<Point> quadNormal(const QuadMesh& mesh, FaceId face) {
    Point sum(0, 0, 0);
    for (const Triangle& half : halvesOf(mesh, face))
        if (const auto normal = triangleNormal(half)) sum += *normal;
    return unit(sum);
}

std::optional<Point> middleNormal(const QuadMesh& mesh, FaceId face) {
    const auto [a, b, c, d] = cornerPoints(mesh, face);
    return unit(scaled(c - a) % scaled(d - b));
}

std::optional<double> minCornerSine(const QuadMesh& mesh, FaceId face) {
    const auto corners = cornerAngles(mesh, face);
    if (!corners) return std::nullopt;
    return std::ranges::min(*corners, {}, &Angle::sine).sine;
}

bool isFolded(const QuadMesh& mesh, FaceId face) {
    const auto angles = cornerAngles(mesh, face);
    if (!angles) return true;
    const auto corners = cornersOf(mesh, face);
    for (std::size_t k = 0; k < 4; ++k)
        if (!((*angles)[k].sine > minSine(mesh, corners[k], (*angles)[k]))) return true;
    return false;
}

double meanEdgeLength(const QuadMesh& mesh) {
    double sum = 0;
    for (const EdgeId edge : mesh.edges())
        sum += mesh.calc_edge_length(edge);
    return mesh.n_edges() > 0 ? sum / static_cast<double>(mesh.n_edges()) : 0;
}

} // namespace qm
