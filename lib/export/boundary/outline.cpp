#include "export/boundary/outline.h"

#include "base/sort_unique.h"

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/linestring.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/ring.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace qm {
namespace {

namespace index = boost::geometry::index;
using PlanePoint = boost::geometry::model::d2::point_xy<double>;
using Ring = boost::geometry::model::ring<PlanePoint>;
using Line = boost::geometry::model::linestring<PlanePoint>;
using Box = boost::geometry::model::box<PlanePoint>;

/// Points along an edge as the loop uses it, in the parameter plane.
Ring curveOn(const BoundaryFace& face, const BoundaryEdge& edge, const EdgeUse& use) {
    constexpr int steps = 8; // in every interval of a curve
    Ring points;
    for (const double parameter : parametersOf(edge.curve, steps)) {
        const gp_Pnt2d at = parametersAt(face, edge, use.side(), parameter);
        points.emplace_back(at.X(), at.Y());
    }
    if (!use.forwards) std::ranges::reverse(points);
    return points;
}

/// Edges begin where the one before ends, but for the tolerance of the vertex: if that is small beside the
/// first step, the two are one point.
void append(const Ring& points, Ring& ring) {
    constexpr double smallGap = 0.05;
    if (!ring.empty()) {
        const double gap = boost::geometry::distance(ring.back(), points.front());
        const double step = boost::geometry::distance(ring[ring.size() - 2], ring.back());
        if (gap < smallGap * step) ring.pop_back();
    }
    ring.insert(ring.end(), points.begin(), points.end());
}

Ring ringOf(const Boundary& boundary, std::size_t face, const std::vector<EdgeUse>& loop) {
    Ring ring;
    for (const EdgeUse& use : loop)
        append(curveOn(boundary.faces[face], boundary.edges[use.edge], use), ring);
    append({ring.front()}, ring);
    return ring;
}

} // namespace

bool outlineCrossesItself(const Boundary& boundary, std::size_t face) {
    return std::ranges::any_of(boundary.faces[face].loops, [&](const std::vector<EdgeUse>& loop) {
        return boost::geometry::intersects(ringOf(boundary, face, loop));
    });
}

std::vector<std::size_t> faultyEdges(const Boundary& boundary, std::size_t face) {
    struct Piece {
        std::size_t edge = 0;
        std::array<std::size_t, 2> ends{};
        Line line;
        Box box;
    };
    std::vector<Piece> pieces;
    std::vector<std::size_t> result;
    std::vector<double> areas;
    for (const std::vector<EdgeUse>& loop : boundary.faces[face].loops) {
        areas.push_back(boost::geometry::area(ringOf(boundary, face, loop)));
        const bool isTurned = areas.size() > 1 && (areas.back() > 0) == (areas.front() > 0);
        for (const EdgeUse& use : loop) {
            if (isTurned) result.push_back(use.edge);
            const BoundaryEdge& edge = boundary.edges[use.edge];
            const Ring points = curveOn(boundary.faces[face], edge, use);
            Piece& piece =
                pieces.emplace_back(Piece{use.edge, edge.ends, Line(points.begin(), points.end()), Box()});
            boost::geometry::envelope(piece.line, piece.box);
        }
    }
    using Entry = std::pair<Box, std::size_t>;
    std::vector<Entry> entries;
    for (std::size_t k = 0; k < pieces.size(); ++k)
        entries.emplace_back(pieces[k].box, k);
    const index::rtree<Entry, index::rstar<8>> boxes(entries);
    for (const auto& [box, k] : entries) {
        const Piece& one = pieces[k];
        for (auto near = boxes.qbegin(index::intersects(box)); near != boxes.qend(); ++near) {
            const Piece& other = pieces[near->second];
            if (near->second >= k || std::ranges::find_first_of(one.ends, other.ends) != one.ends.end() ||
                !boost::geometry::intersects(one.line, other.line))
                continue;
            result.insert(result.end(), {one.edge, other.edge});
        }
    }
    sortUnique(result);
    return result;
}

} // namespace qm
