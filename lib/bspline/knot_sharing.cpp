#include "bspline/knot_sharing.h"

#include <algorithm>
#include <map>

namespace qm {
namespace {

/// A piece of a side over the patch's parameter there.
struct Stretch {
    double begin = 0; ///< the patch's parameter
    double end = 0;
    std::size_t chain = 0;
    double atBegin = 0; ///< the chain's parameter that belongs to `begin`
    int sign = 1;
};

/// \param along  the patch's parameter runs along the side, not against it
std::vector<Stretch> stretches(const Chains& chains, std::size_t patch, int side, int size, bool along) {
    std::vector<Stretch> result;
    double position = 0;
    for (const SidePiece& piece : chains.pieces(patch, side)) {
        const double length = chains.all()[piece.place.chain].length();
        const bool forwards = piece.place.way == 0;
        const double start = forwards ? piece.place.position : length - piece.place.position;
        Stretch stretch{position, position + piece.length, piece.place.chain, start, forwards ? 1 : -1};
        if (!along) {
            stretch.atBegin += stretch.sign * piece.length;
            stretch.sign = -stretch.sign;
            stretch.begin = size - (position + piece.length);
            stretch.end = size - position;
        }
        result.push_back(stretch);
        position += piece.length;
    }
    return result;
}

} // namespace

KnotSharing::KnotSharing(const Chains& chains, const Layout& layout) : facings_(chains.all().size()) {
    for (std::size_t patch = 0; patch < layout.segments.size(); ++patch)
        for (int side = 0; side < 4; ++side) {
            const auto& size = layout.segments[patch].size;
            const std::size_t direction = side % 2 == 0 ? 0 : 1;
            const int other = (side + 2) % 4;
            const auto own = stretches(chains, patch, side, size[direction], side < 2);
            const auto opposite = stretches(chains, patch, other, size[direction], other < 2);
            for (const Stretch& a : own)
                for (const Stretch& b : opposite) {
                    const double begin = std::max(a.begin, b.begin);
                    const double end = std::min(a.end, b.end);
                    if (!(begin < end)) continue;
                    const double from = a.atBegin + a.sign * (begin - a.begin);
                    const double to = a.atBegin + a.sign * (end - a.begin);
                    Facing facing;
                    facing.begin = std::min(from, to);
                    facing.end = std::max(from, to);
                    facing.opposite = b.chain;
                    const double there = a.sign > 0 ? begin : end;
                    facing.first = b.atBegin + b.sign * (there - b.begin);
                    facing.sign = a.sign * b.sign;
                    facing.patch = patch;
                    facing.cost = size[1 - direction] + 3;
                    facings_[a.chain].push_back(facing);
                }
        }
}

std::vector<KnotPlace> KnotSharing::places(std::size_t chain, const std::vector<SplineCurve>& curves) const {
    std::map<double, int> costs;
    const double length = curves[chain].length();
    const auto consider = [&](double knot) {
        if (knot > 0 && knot < length) costs.emplace(knot, 0);
    };
    for (const double knot : curves[chain].knots)
        consider(knot);
    const auto onOpposite = [](const Facing& facing, double knot) {
        return facing.first + facing.sign * (knot - facing.begin);
    };
    for (const Facing& facing : facings_[chain])
        for (const double knot : curves[facing.opposite].knots) {
            const double here = facing.begin + facing.sign * (knot - facing.first);
            if (here > facing.begin && here < facing.end) consider(here);
        }
    for (const Facing& facing : facings_[chain])
        for (auto place = costs.upper_bound(facing.begin); place != costs.end() && place->first < facing.end;
             ++place) {
            const auto& knots = curves[facing.opposite].knots;
            if (!std::binary_search(knots.begin(), knots.end(), onOpposite(facing, place->first)))
                place->second += facing.cost;
        }
    std::vector<KnotPlace> result;
    result.reserve(costs.size());
    for (const auto& [parameter, cost] : costs)
        result.push_back({parameter, cost});
    std::stable_sort(result.begin(), result.end(),
                     [](const KnotPlace& a, const KnotPlace& b) { return a.cost > b.cost; });
    return result;
}

} // namespace qm
