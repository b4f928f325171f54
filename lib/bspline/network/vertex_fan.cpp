#include "bspline/network/vertex_fan.h"

#include "base/at.h"
#include "mesh/angle_between.h"
#include "mesh/topology.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>

namespace qm {
namespace {

/// Consecutive patches of a fan with creases at both ends only; or all, if there is at most one crease.
struct Sector {
    std::size_t begin = 0; ///< the border at which it begins
    std::size_t size = 0;  ///< how many patches it has
    bool isWhole = false;  ///< it begins and ends at the same border
};

std::vector<Sector> sectors(const VertexFan& fan) {
    const std::size_t count = fan.borders.size();
    std::vector<std::size_t> creases;
    for (std::size_t k = 0; k < count; ++k)
        if (fan.isCrease[k]) creases.push_back(k);
    if (creases.size() <= 1) return {{creases.empty() ? 0 : creases.front(), count, true}};
    std::vector<Sector> result;
    for (std::size_t k = 0; k < creases.size(); ++k) {
        const bool last = k + 1 == creases.size();
        if (last && !fan.isClosed) break;
        const std::size_t end = last ? creases.front() + count : creases[k + 1];
        result.push_back({creases[k], end - creases[k], false});
    }
    return result;
}

/// The angle of each patch of a sector that has a corner at the vertex, if those whose sides pass straight
/// through take half a turn each; nothing if that leaves no room.
std::optional<double> angleOfCorners(const VertexFan& fan, const Sector& sector, int halfTurns) {
    int corners = 0;
    for (std::size_t k = 0; k < sector.size; ++k) {
        if (fan.faces[(sector.begin + k) % fan.borders.size()] == 1)
            ++corners;
        else
            --halfTurns;
    }
    if (corners == 0) return halfTurns >= 0 ? std::optional(0.0) : std::nullopt;
    return halfTurns > 0 ? std::optional(halfTurns * std::numbers::pi / corners) : std::nullopt;
}

/// The direction in which a patch leaves the vertex and a border on one side of it: along the border on its
/// other side, or, if its side passes straight through, along the mesh edge between its two faces.
Point awayFrom(std::size_t border, const QuadMesh& mesh, const VertexFan& fan, std::size_t patch) {
    const std::size_t next = (patch + 1) % fan.borders.size();
    if (fan.faces[patch] == 1) return mesh.calc_edge_vector(fan.borders[border == patch ? next : patch]);
    return mesh.calc_edge_vector(mesh.ccw_rotated_halfedge_handle(fan.borders[patch]));
}

/// The ratio of the mesh itself.
double measuredRatio(const QuadMesh& mesh, const VertexFan& fan, std::size_t border) {
    const std::size_t count = fan.borders.size();
    const Point on = mesh.calc_edge_vector(fan.borders[border]);
    const Point sum =
        awayFrom(border, mesh, fan, border) + awayFrom(border, mesh, fan, (border + count - 1) % count);
    constexpr double max = 1.8; // below 2, which no regular spread of edges reaches
    const double length = on.sqrnorm();
    return length > 0 ? std::clamp((sum | on) / length, -max, max) : 0;
}

/// Ratios for the borders inside a sector at a corner that agree with the directions of all of its edges in
/// the mesh, seen in the tangent plane. With angles a_k between edge k and the next, and lengths l_k, the sum
/// of edges k - 1 and k + 1 lies along edge k if l_{k-1} sin a_{k-1} = l_{k+1} sin a_k. So the lengths of
/// every second edge follow from one another; their common factor is the one that comes nearest to the
/// mesh's. Nothing where sides of patches pass straight through, or angles are too near to 0 or half a turn.
std::optional<std::vector<double>> balancedRatios(const QuadMesh& mesh, const VertexFan& fan,
                                                  const Sector& sector) {
    constexpr double minSine = 0.5; // of angles from 30 to 150 degrees
    constexpr double max = 3;       // a border that has to be tied more tightly is tied as the mesh has it
    const std::size_t count = fan.borders.size();
    const auto edge = [&](std::size_t k) {
        return mesh.calc_edge_vector(fan.borders[(sector.begin + k) % count]);
    };
    std::vector<double> angles;
    for (std::size_t k = 0; k < sector.size; ++k) {
        if (fan.faces[(sector.begin + k) % count] != 1) return std::nullopt;
        angles.push_back(angleBetween(edge(k), edge(k + 1)));
        if (!(std::sin(angles.back()) > minSine)) return std::nullopt;
    }
    std::vector<double> lengths(sector.size + 1, 1);
    for (std::size_t k = 2; k <= sector.size; ++k)
        lengths[k] = lengths[k - 2] * std::sin(angles[k - 2]) / std::sin(angles[k - 1]);
    for (const std::size_t parity : {0U, 1U}) {
        double logarithms = 0;
        double terms = 0;
        for (std::size_t k = parity; k <= sector.size; k += 2) {
            logarithms += std::log(edge(k).norm() / lengths[k]);
            ++terms;
        }
        for (std::size_t k = parity; k <= sector.size; k += 2)
            lengths[k] *= std::exp(logarithms / terms);
    }
    std::vector<double> ratios;
    for (std::size_t k = 1; k < sector.size; ++k) {
        ratios.push_back((lengths[k - 1] * std::cos(angles[k - 1]) + lengths[k + 1] * std::cos(angles[k])) /
                         lengths[k]);
        if (!(std::abs(ratios.back()) <= max)) return std::nullopt;
    }
    return ratios;
}

/// Ratios up to this become zero at corners: the direction of an edge may be off by a degree there, and a
/// ratio of zero saves double knots.
constexpr double negligible = 0.02;
constexpr double rounding = 1e-12; ///< elsewhere: what computing with angles leaves of zero

} // namespace

VertexFan vertexFan(const QuadMesh& mesh, const BorderMarks& marks, VertexId vertex) {
    const auto edge = [&](HalfedgeId halfedge) { return at(mesh.edge_handle(halfedge)); };
    VertexFan fan;
    fan.isClosed = !mesh.is_boundary(vertex);
    std::vector<HalfedgeId> leaving = leavingFrom(mesh, mesh.halfedge_handle(vertex));
    // On the boundary the first halfedge counter-clockwise is the one with a face whose opposite has none.
    const auto first = std::ranges::find_if(leaving, [&](HalfedgeId halfedge) {
        return fan.isClosed ? marks.isBorder[edge(halfedge)]
                            : mesh.is_boundary(mesh.opposite_halfedge_handle(halfedge));
    });
    std::rotate(leaving.begin(), first, leaving.end());
    for (const HalfedgeId halfedge : leaving) {
        if (marks.isBorder[edge(halfedge)]) {
            fan.borders.push_back(halfedge);
            fan.isCrease.push_back(marks.isCrease[edge(halfedge)]);
            fan.faces.push_back(0);
        }
        if (!fan.faces.empty() && !mesh.is_boundary(halfedge)) ++fan.faces.back();
    }
    return fan;
}

std::vector<double> tangentRatios(const QuadMesh& mesh, const VertexFan& fan, const VertexRule& rule) {
    const std::size_t count = fan.borders.size();
    const auto isPassed = [&](std::size_t border) { return rule.onward(fan.borders[border]).is_valid(); };
    std::vector<double> ratios(count);
    for (const Sector& sector : sectors(fan)) {
        const std::size_t end = sector.begin + sector.size;
        const bool isCorner = !sector.isWhole && !(isPassed(sector.begin) && isPassed(end % count));
        std::optional<double> angle;
        if (!isCorner) angle = angleOfCorners(fan, sector, sector.isWhole ? 2 : 1);
        const auto balanced = isCorner ? balancedRatios(mesh, fan, sector) : std::nullopt;
        for (std::size_t k = sector.begin + (sector.isWhole ? 0 : 1); k < end; ++k) {
            const std::size_t border = k % count;
            if (fan.isCrease[border]) continue;
            const std::size_t before = (border + count - 1) % count;
            const auto cosine = [&](std::size_t patch) {
                return fan.faces[patch] == 1 ? std::cos(*angle) : 0;
            };
            double ratio = angle      ? cosine(border) + cosine(before)
                           : balanced ? (*balanced)[k - sector.begin - 1]
                                      : measuredRatio(mesh, fan, border);
            if (std::abs(ratio) < (isCorner ? negligible : rounding)) ratio = 0;
            ratios[border] = ratio;
        }
    }
    return ratios;
}

} // namespace qm
