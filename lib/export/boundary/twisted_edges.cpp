#include "export/boundary/divided_edges.h"
#include "export/boundary/edge_angle.h"

#include <algorithm>
#include <gp_Dir.hxx>
#include <gp_Vec.hxx>
#include <numbers>
#include <optional>

namespace qm {
namespace {

constexpr double maxTwist = std::numbers::pi / 3;
constexpr double minBend = std::numbers::pi / 360; ///< a straighter edge is its own chord
constexpr int samples = 8;                         ///< along an edge
constexpr int maxRounds = 3;                       ///< an edge becomes eight at most

/// The largest angle between any two.
double spread(const std::vector<gp_Dir>& directions) {
    double largest = 0;
    for (const gp_Dir& one : directions)
        for (const gp_Dir& other : directions)
            largest = std::max(largest, one.Angle(other));
    return largest;
}

/// Whether a face's normal turns much farther along an edge than the edge does.
bool isTwisted(const BoundaryFace& face, const BoundaryEdge& edge, std::size_t side) {
    const CurvePiece& curve = edge.curve;
    std::vector<gp_Dir> normals, tangents;
    for (int k = 0; k <= samples; ++k) {
        const double parameter = curve.first + (curve.last - curve.first) * k / samples;
        if (const auto normal = normalAt(face, edge, side, parameter)) normals.push_back(*normal);
        gp_Pnt point;
        gp_Vec tangent;
        curve.curve->D1(parameter, point, tangent);
        if (tangent.Magnitude() > gp::Resolution()) tangents.emplace_back(tangent);
    }
    const double bend = spread(tangents);
    return bend > minBend && spread(normals) - bend > maxTwist;
}

} // namespace

bool divideTwistedEdges(Boundary& boundary) {
    const auto divideOnce = [&] {
        std::vector<std::optional<double>> divisions(boundary.edges.size());
        forEachUse(boundary, [&](std::size_t f, const EdgeUse& use) {
            const BoundaryFace& face = boundary.faces[f];
            const BoundaryEdge& edge = boundary.edges[use.edge];
            if (face.isSimple || divisions[use.edge]) return;
            if (isTwisted(face, edge, use.side()))
                divisions[use.edge] = (edge.curve.first + edge.curve.last) / 2;
        });
        return divideEdges(boundary, divisions);
    };
    int rounds = 0;
    while (rounds < maxRounds && divideOnce())
        ++rounds;
    return rounds > 0;
}

} // namespace qm
