#include "export/boundary/divided_edges.h"

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

namespace qm {
namespace {

/// An edge's distance from the surfaces of its faces, by its parameter.
class Looseness {
public:
    explicit Looseness(const BoundaryEdge& edge) : edge_(edge) {}

    void add(const BoundaryFace& face, std::size_t side) { faces_.emplace_back(&face, side); }

    [[nodiscard]] double at(double parameter) const {
        const gp_Pnt point = edge_.curve.at(parameter);
        double distance = 0;
        for (const auto& [face, side] : faces_) {
            const gp_Pnt2d on = parametersAt(*face, edge_, side, parameter);
            distance = std::max(distance, point.Distance(face->surface->Value(on.X(), on.Y())));
        }
        return distance;
    }

    /// Where the distance is largest.
    [[nodiscard]] double farthest() const {
        constexpr int perInterval = 16;
        const std::vector<double> parameters = parametersOf(edge_.curve, perInterval);
        std::vector<double> distances(parameters.size());
        std::ranges::transform(parameters, distances.begin(),
                               [&](double parameter) { return at(parameter); });
        const std::size_t last = parameters.size() - 1;
        // Of two maxima that are nearly equal, the larger one may have the smaller sample.
        constexpr double nearly = 0.9;
        const double min = nearly * std::ranges::max(distances);
        double largest = -1;
        double place = 0;
        for (std::size_t k = 0; k <= last; ++k) {
            const std::size_t before = std::max<std::size_t>(k, 1) - 1;
            const std::size_t after = std::min(k + 1, last);
            if (distances[k] < std::max({min, distances[before], distances[after]})) continue;
            for (const double candidate : {parameters[k], maximum(parameters[before], parameters[after])})
                if (const double distance = at(candidate); distance > largest) {
                    largest = distance;
                    place = candidate;
                }
        }
        return place;
    }

private:
    [[nodiscard]] double maximum(double begin, double end) const {
        constexpr int bits = std::numeric_limits<double>::digits / 2; // an extremum has no more
        return boost::math::tools::brent_find_minima([&](double t) { return -at(t); }, begin, end, bits)
            .first;
    }

    const BoundaryEdge& edge_;
    std::vector<std::pair<const BoundaryFace*, std::size_t>> faces_; ///< with their sides
};

/// Where to divide an edge, if that is worth while.
std::optional<double> division(const BoundaryEdge& edge, const Looseness& looseness, double resolution) {
    constexpr double margin = 4; // the parts are longer than their distance by this factor
    const double at = looseness.farthest();
    const double distance = looseness.at(at);
    if (!(distance > resolution)) return std::nullopt;
    const gp_Pnt point = edge.curve.at(at);
    const double nearest = std::min(point.Distance(edge.curve.start()), point.Distance(edge.curve.end()));
    return nearest > margin * distance ? std::optional(at) : std::nullopt;
}

/// By edge: where to divide it, if at all.
std::vector<std::optional<double>> divisionsOf(const Boundary& boundary) {
    std::vector<Looseness> looseness(boundary.edges.begin(), boundary.edges.end());
    forEachUse(boundary, [&](std::size_t face, const EdgeUse& use) {
        looseness[use.edge].add(boundary.faces[face], use.side());
    });
    std::vector<std::optional<double>> divisions;
    for (std::size_t e = 0; e < boundary.edges.size(); ++e)
        divisions.push_back(division(boundary.edges[e], looseness[e], boundary.resolution));
    return divisions;
}

} // namespace

bool divideLooseEdges(Boundary& boundary) {
    return divideEdges(boundary, divisionsOf(boundary));
}

} // namespace qm
