/// \file The quads into which polygons are divided.
#pragma once

#include "remesh/polygons/convex_pieces.h"
#include "remesh/polygons/polygon_edges.h"
#include "remesh/polygons/subdivision_step.h"

#include <array>
#include <cstddef>
#include <map>
#include <vector>

namespace qm {

/// A quad, and the polygon of which it is a part.
struct PartQuad {
    std::array<std::size_t, 4> points;
    std::size_t face;
};

/// Divides every polygon at points in the middle of its sides: around its middle, into as many quads as it
/// has corners, or by its grid. Points are numbered: vertices, edges, then those inside of
/// polygons.
class QuadDivision {
public:
    /// Both arguments must outlive the division.
    QuadDivision(const ConvexPieces& pieces, const PolygonEdges& edges);

    [[nodiscard]] const std::vector<PartQuad>& quads() const { return quads_; }
    [[nodiscard]] std::vector<Point> pointsOf(StepPoints points) const;

private:
    [[nodiscard]] std::vector<std::size_t> rimOf(std::size_t face) const;
    void divideAroundMiddle(std::size_t face);
    void divideByGrid(std::size_t face, const GridFilling& filling);

    const Soup& soup_;
    const std::map<std::size_t, GridFilling>& grids_; ///< by face
    const PolygonEdges& edges_;
    std::size_t pointCount_;
    std::vector<PartQuad> quads_;
};

} // namespace qm
