#include "bspline/network/stretches.h"

#include "layout/sides.h"

#include <tuple>

namespace qm {
namespace {

bool follows(const BorderEdge& edge, const BorderEdge& before) {
    const auto& [first, second] = std::tie(edge.places[0], edge.places[1]);
    const auto& [firstBefore, secondBefore] = std::tie(before.places[0], before.places[1]);
    return first.patch == firstBefore.patch && first.side == firstBefore.side &&
           first.position == firstBefore.position + 1 && second.patch == secondBefore.patch &&
           second.side == secondBefore.side && second.position == secondBefore.position - 1;
}

Stretch beginAt(const BorderEdge& edge) {
    const BorderPlace& first = edge.places[0];
    const BorderPlace& second = edge.places[1];
    Stretch stretch;
    stretch.sides = {StretchSide{first.patch, first.side, first.position, 1},
                     StretchSide{second.patch, second.side, second.position + 1, -1}};
    return stretch;
}

/// The patch's parameter at a distance from a side's beginning, and the other way round.
double alongPatch(const std::array<int, 2>& size, int side, double distance) {
    return alongSide<double>(side, distance, size[directionAlong(side)]);
}

} // namespace

double patchParameter(const std::array<int, 2>& size, const StretchSide& place, double x) {
    return alongPatch(size, place.side, place.origin + place.direction * x);
}

std::array<double, 2> patchPlace(const std::array<int, 2>& size, const StretchSide& place, double x) {
    return placeOnSide(size, place.side, place.origin + place.direction * x);
}

double stretchParameter(const std::array<int, 2>& size, const StretchSide& place, double parameter) {
    return (alongPatch(size, place.side, parameter) - place.origin) * place.direction;
}

std::vector<Stretch> findStretches(const std::vector<BorderEdge>& borders) {
    std::vector<Stretch> stretches;
    const BorderEdge* before = nullptr;
    for (const BorderEdge& edge : borders) {
        if (edge.places.size() != 2) {
            before = nullptr;
            continue;
        }
        if (before == nullptr || !follows(edge, *before)) stretches.push_back(beginAt(edge));
        stretches.back().halfedges.push_back(edge.halfedge);
        before = &edge;
    }
    return stretches;
}

std::vector<bool> withNeighbours(const std::vector<Stretch>& stretches, std::vector<bool> patches,
                                 int rings) {
    for (int ring = 0; ring < rings; ++ring) {
        const std::vector<bool> before = patches;
        for (const Stretch& stretch : stretches)
            for (const std::size_t side : {0U, 1U})
                if (before[stretch.sides[side].patch]) patches[stretch.sides[1 - side].patch] = true;
    }
    return patches;
}

} // namespace qm
