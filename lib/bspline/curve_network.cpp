#include "bspline/curve_network.h"

#include <algorithm>

namespace qm {

CurveNetwork::CurveNetwork(const QuadMesh& mesh, const Chains& chains, const LineDerivatives& lines)
    : mesh_(mesh), chains_(chains), lines_(lines), across_(chains.all().size()) {
    fitPositions();
    prepareAcross();
    settleTwists();
    for (const auto& ofChain : across_) {
        auto& curves = inwards_.emplace_back();
        for (std::size_t way = 0; way < 2; ++way)
            if (ofChain[way].present)
                curves[way] = interpolateClamped(ofChain[way].values, ofChain[way].slopes.front(),
                                                 ofChain[way].slopes.back());
    }
}

void CurveNetwork::fitPositions() {
    for (const BorderChain& chain : chains_.all()) {
        std::vector<Point> points = {mesh_.point(mesh_.from_vertex_handle(chain.halfedges.front()))};
        for (const HalfedgeId halfedge : chain.halfedges)
            points.push_back(mesh_.point(mesh_.to_vertex_handle(halfedge)));
        const Point start = lines_.tangent(chain.halfedges.front());
        const Point end = -lines_.tangent(mesh_.opposite_halfedge_handle(chain.halfedges.back()));
        slopes_.push_back(splineSlopes(points, start, end));
        positions_.push_back(interpolateClamped(points, start, end));
    }
}

/// The edge that leads inwards, or along the patch's next side, where an edge of a chain begins.
HalfedgeId CurveNetwork::acrossAt(const ChainPlace& place) const {
    return mesh_.opposite_halfedge_handle(mesh_.prev_halfedge_handle(chains_.halfedge(place)));
}

/// The same where it ends.
HalfedgeId CurveNetwork::acrossAtEnd(const ChainPlace& last) const {
    return mesh_.next_halfedge_handle(chains_.halfedge(last));
}

/// Derivative, at the vertex that the halfedge leaves, of the border curve there, or of the mesh's line.
Point CurveNetwork::tangentAt(HalfedgeId halfedge) const {
    if (!chains_.isBorder(mesh_.edge_handle(halfedge))) return lines_.tangent(halfedge);
    const ChainPlace place = chains_.place(halfedge);
    const auto& slopes = slopes_[place.chain];
    const auto position = static_cast<std::size_t>(place.position);
    return place.way == 0 ? slopes[position] : -slopes[slopes.size() - 1 - position];
}

void CurveNetwork::prepareAcross() {
    for (std::size_t c = 0; c < across_.size(); ++c)
        for (int way = 0; way < 2; ++way) {
            Across& across = across_[c][static_cast<std::size_t>(way)];
            across.present = chains_.hasPatch(c, way);
            if (!across.present) continue;
            const int last = chains_.all()[c].length() - 1;
            across.values.push_back(tangentAt(acrossAt({c, way, 0})));
            for (int k = 1; k <= last; ++k)
                across.values.push_back(lines_.tangent(acrossAt({c, way, k})));
            across.values.push_back(tangentAt(acrossAtEnd({c, way, last})));
            across.slopes.assign(across.values.size(), Point(0, 0, 0));
            across.slopes.front() = lines_.twist(chains_.halfedge({c, way, 0}));
            across.slopes.back() = -lines_.twist(acrossAtEnd({c, way, last}));
        }
}

void CurveNetwork::solve(Across& across) {
    across.slopes = splineSlopes(across.values, across.slopes.front(), across.slopes.back());
}

/// The twist of the patch on the left where a chain begins; its own estimate unless it begins on another
/// chain.
Point CurveNetwork::twistAtStart(const ChainPlace& first) const {
    const Point own = across_[first.chain][static_cast<std::size_t>(first.way)].slopes.front();
    const HalfedgeId other = acrossAt(first);
    if (!chains_.isBorder(mesh_.edge_handle(other))) return own;
    // The patch is on the left of the other chain when that is walked towards this place.
    const ChainPlace place = chains_.place(mesh_.opposite_halfedge_handle(other));
    if (place.position + 1 == chains_.all()[place.chain].length()) return own;
    return -across_[place.chain][static_cast<std::size_t>(place.way)]
                .slopes[static_cast<std::size_t>(place.position) + 1];
}

/// The same where it ends, as the slope of its own derivative across.
Point CurveNetwork::twistAtEnd(const ChainPlace& last) const {
    const Point own = across_[last.chain][static_cast<std::size_t>(last.way)].slopes.back();
    const HalfedgeId other = acrossAtEnd(last);
    if (!chains_.isBorder(mesh_.edge_handle(other))) return own;
    const ChainPlace place = chains_.place(other);
    if (place.position == 0) return own;
    return -across_[place.chain][static_cast<std::size_t>(place.way)]
                .slopes[static_cast<std::size_t>(place.position)];
}

/// \return  the largest change, squared
double CurveNetwork::updateTwists() {
    double change = 0;
    for (std::size_t c = 0; c < across_.size(); ++c)
        for (int way = 0; way < 2; ++way) {
            Across& across = across_[c][static_cast<std::size_t>(way)];
            if (!across.present) continue;
            const Point start = twistAtStart({c, way, 0});
            const Point end = twistAtEnd({c, way, chains_.all()[c].length() - 1});
            change = std::max(
                {change, (start - across.slopes.front()).sqrnorm(), (end - across.slopes.back()).sqrnorm()});
            across.slopes.front() = start;
            across.slopes.back() = end;
            solve(across);
        }
    return change;
}

/// Chains may end on one another in a circle, so their twists are found by repetition. A T-joint is at least
/// one edge away from its chain's ends, whose slopes fade to at most 2 / 7 there: it converges.
void CurveNetwork::settleTwists() {
    double largest = 0;
    for (auto& ofChain : across_)
        for (Across& across : ofChain)
            if (across.present) {
                solve(across);
                for (const Point& slope : across.slopes)
                    largest = std::max(largest, slope.sqrnorm());
            }
    for (int round = 0; round < 60; ++round)
        if (updateTwists() <= 1e-32 * largest) break;
}

SideCurves CurveNetwork::side(std::size_t patch, int side) const {
    std::vector<SplineCurve> positions;
    std::vector<SplineCurve> inwards;
    for (const SidePiece& piece : chains_.pieces(patch, side)) {
        const ChainPlace& place = piece.place;
        const SplineCurve& forwards = positions_[place.chain];
        const double begin = place.position;
        const double end = begin + piece.length;
        const double length = forwards.length();
        positions.push_back(place.way == 0 ? restricted(forwards, begin, end)
                                           : reversed(restricted(forwards, length - end, length - begin)));
        inwards.push_back(restricted(inwards_[place.chain][static_cast<std::size_t>(place.way)], begin, end));
    }
    return {joined(positions), joined(inwards)};
}

} // namespace qm
