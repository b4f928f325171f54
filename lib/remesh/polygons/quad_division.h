/// \file The quads into which polygons are divided.
#pragma once

#include "mesh/soup/soup.h"
#include "remesh/polygons/grid_filling.h"
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
/// has corners, or by a grid (see `needsGrid`). Points are numbered: vertices, edges, then those inside of
/// polygons.
class QuadDivision {
public:
    /// \param soup  must outlive the division
    QuadDivision(const Soup& soup, const PolygonEdges& edges);

    [[nodiscard]] const std::vector<PartQuad>& quads() const { return quads_; }
    [[nodiscard]] std::vector<Point> pointsOf(StepPoints points) const;

private:
    [[nodiscard]] std::vector<std::size_t> rimOf(std::size_t face) const;
    void divideAroundMiddle(std::size_t face);
    void divideByGrid(std::size_t face, GridFilling filling);

    const Soup& soup_;
    const PolygonEdges& edges_;
    std::size_t pointCount_;
    std::map<std::size_t, GridFilling> grids_; ///< by face
    std::vector<PartQuad> quads_;
};

} // namespace qm
