#include "remesh/polygons/quad_division.h"

#include "base/at.h"

#include <utility>

namespace qm {

QuadDivision::QuadDivision(const ConvexPieces& pieces, const PolygonEdges& edges)
    : soup_(pieces.soup), grids_(pieces.grids), edges_(edges),
      pointCount_(soup_.points.size() + edges.ends.size()) {
    for (std::size_t face = 0; face < soup_.faceCount(); ++face)
        if (const auto grid = grids_.find(face); grid != grids_.end())
            divideByGrid(face, grid->second);
        else
            divideAroundMiddle(face);
}

std::vector<Point> QuadDivision::pointsOf(StepPoints points) const {
    std::vector<Point> all = std::move(points.vertices);
    all.reserve(pointCount_);
    all.insert(all.end(), points.edges.begin(), points.edges.end());
    for (std::size_t face = 0; face < soup_.faceCount(); ++face) {
        const auto grid = grids_.find(face);
        if (grid == grids_.end()) {
            all.push_back(points.faces[face]);
            continue;
        }
        std::vector<Point> rim;
        for (const std::size_t point : rimOf(face))
            rim.push_back(all[point]);
        const std::vector<Point> inner = innerPoints(grid->second, rim);
        all.insert(all.end(), inner.begin(), inner.end());
    }
    return all;
}

/// The points along a face, from its first corner over the middle of the side from there.
std::vector<std::size_t> QuadDivision::rimOf(std::size_t face) const {
    std::vector<std::size_t> rim;
    rim.reserve(2 * soup_.face(face).size());
    for (std::size_t corner = soup_.faceBegins[face]; corner < soup_.faceBegins[face + 1]; ++corner) {
        rim.push_back(at(soup_.corners[corner]));
        rim.push_back(soup_.points.size() + edges_.edgeOf[corner]);
    }
    return rim;
}

void QuadDivision::divideAroundMiddle(std::size_t face) {
    const std::vector<std::size_t> rim = rimOf(face);
    const std::size_t middle = pointCount_++;
    for (std::size_t k = 0; k < rim.size(); k += 2)
        quads_.push_back({{rim[k], rim[k + 1], middle, rim[(k + rim.size() - 1) % rim.size()]}, face});
}

void QuadDivision::divideByGrid(std::size_t face, const GridFilling& filling) {
    const std::vector<std::size_t> rim = rimOf(face);
    const std::size_t firstInner = pointCount_;
    pointCount_ += filling.innerPoints;
    for (const auto& quad : filling.quads) {
        PartQuad& part = quads_.emplace_back(PartQuad{quad, face});
        for (std::size_t& point : part.points)
            point = point < rim.size() ? rim[point] : firstInner + point - rim.size();
    }
}

} // namespace qm
