#include "remesh/polygons/subdivide_polygons.h"

#include "base/error.h"
#include "remesh/polygons/convex_pieces.h"
#include "remesh/polygons/polygon_edges.h"
#include "remesh/polygons/quad_division.h"
#include "remesh/polygons/subdivision_step.h"

#include <algorithm>
#include <array>
#include <vector>

namespace qm {
namespace {

/// Quads whose corners have a smaller sine than this are divided in straight lines instead, as long as that
/// makes others fold, in at most so many rounds.
constexpr double minSine = 0.1;
constexpr int maxRounds = 10;

double minCornerSine(const std::vector<Point>& points, const std::array<std::size_t, 4>& quad,
                     const Point& normal) {
    double least = 1;
    for (std::size_t k = 0; k < 4; ++k) {
        const Point to = (points[quad[(k + 1) % 4]] - points[quad[k]]).normalize_cond();
        const Point from = (points[quad[(k + 3) % 4]] - points[quad[k]]).normalize_cond();
        least = std::min(least, (to % from) | normal);
    }
    return least;
}

/// Moves the points of quads that are folded, seen along the normal of their polygon, to where straight lines
/// divide it.
void straighten(std::vector<Point>& points, const std::vector<Point>& straight, const Soup& soup,
                const std::vector<PartQuad>& quads) {
    std::vector<Point> normals(soup.faceCount());
    for (std::size_t face = 0; face < normals.size(); ++face)
        normals[face] = areaVector(soup, face).normalize_cond();
    bool isDone = false;
    for (int round = 0; round < maxRounds && !isDone; ++round) {
        isDone = true;
        for (const auto& [corners, face] : quads) {
            if (minCornerSine(points, corners, normals[face]) >= minSine) continue;
            for (const std::size_t point : corners) {
                isDone = isDone && points[point] == straight[point];
                points[point] = straight[point];
            }
        }
    }
}

} // namespace

Soup subdividePolygons(const Soup& soup, double rho) {
    const ConvexPieces pieces = convexPieces(soup);
    const Soup& convex = pieces.soup;
    if (convex.faceCount() == 0)
        throw Error("", "none of its faces has three different corners", "Use another copy of the file");
    const PolygonEdges edges = polygonEdges(convex, rho);
    const SubdivisionStep step(convex, edges);
    const QuadDivision division(pieces, edges);
    Soup result;
    result.points = division.pointsOf(step.through(convex.points));
    straighten(result.points, division.pointsOf(step.straight(convex.points)), convex, division.quads());
    for (const PartQuad& quad : division.quads())
        result.addFace(quad.points);
    return result;
}

} // namespace qm
