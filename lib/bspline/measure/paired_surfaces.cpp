#include "bspline/measure/paired_surfaces.h"

#include "base/at.h"
#include "base/parallel.h"
#include "bspline/measure/border_measures.h"
#include "layout/sides.h"

#include <algorithm>
#include <utility>

namespace qm {
namespace {

int commonDegree(const std::vector<Patch>& patches, const std::vector<ReferenceGrid>& references) {
    int degree = 1;
    for (const Patch& patch : patches)
        degree = std::max({degree, patch.degree[0], patch.degree[1]});
    for (const ReferenceGrid& reference : references)
        degree = std::max(degree, reference.steps);
    return degree;
}

/// Whether patches meet along a border edge up to rounding.
bool isGapless(const Layout& layout, const std::vector<Patch>& patches, const BorderEdge& border) {
    constexpr double negligible = 1e-7; // of the border's length
    // As many points as cubics that are not equal cannot have in common.
    std::array<std::array<Point, 4>, 2> points;
    for (std::size_t k = 0; k < 4; ++k) {
        const auto [own, other] = pointsOnBothSides(layout, patches, border, static_cast<double>(k) / 3);
        points[0][k] = own.position;
        points[1][k] = other.position;
    }
    const double length = (points[0].front() - points[0].back()).norm();
    const auto meet = [&](const Point& a, const Point& b) { return (a - b).norm() <= negligible * length; };
    return std::ranges::equal(points[0], points[1], meet);
}

} // namespace

PairedSurfaces::PairedSurfaces(const Layout& layout, const std::vector<Patch>& patches,
                               const std::vector<ReferenceGrid>& references,
                               const std::vector<BorderEdge>& borders, unsigned jobs)
    : layout_(layout), beyond_(patches.size()) {
    const int degree = commonDegree(patches, references);
    pieces_.fill(std::vector<BezierPieces>(patches.size()));
    parallelFor(patches.size(), jobs, [&](std::size_t p) {
        const ReferenceGrid& reference = references[p];
        const auto breaks = knotsAndGridLines(patches[p]);
        BezierPieces& ofReference = pieces_[1][p];
        for (std::size_t k = 0; k < 2; ++k)
            ofReference.along[k] = latticeExtraction(reference.steps, breaks[k], degree);
        ofReference.controls = reference.points;
        ofReference.width = reference.columns();
        pieces_[0][p] = bezierPieces(patches[p], breaks, {degree, degree});

        for (int side = 0; side < 4; ++side)
            beyond_[p][at(side)].resize(at(layout.segments[p].size[directionAlong(side)]));
    });
    const auto entry = [this](const BorderPlace& place) -> Beyond& {
        return beyond_[place.patch][at(place.side)][at(place.position)];
    };
    parallelForMany(borders.size(), jobs, [&](std::size_t k) {
        const BorderEdge& border = borders[k];
        if (border.places.size() != 2) return;
        const bool gapless = isGapless(layout, patches, border);
        entry(border.places[0]) = {border.places[1], gapless};
        entry(border.places[1]) = {border.places[0], gapless};
    });
}

Parameters PairedSurfaces::extent(std::size_t patch) const {
    const auto& size = layout_.segments[patch].size;
    return {static_cast<double>(size[0]), static_cast<double>(size[1])};
}

std::vector<Cell> PairedSurfaces::cells(std::size_t patch) const {
    const auto& [u, v] = pieces_[0][patch].along;
    std::vector<Cell> result;
    result.reserve(u.intervals() * v.intervals());
    for (std::size_t j = 0; j < v.intervals(); ++j)
        for (std::size_t i = 0; i < u.intervals(); ++i)
            result.push_back({patch, {i, j}});
    return result;
}

ParameterBox PairedSurfaces::box(const Cell& cell) const {
    const auto& [u, v] = pieces_[0][cell.patch].along;
    return {u.range(cell.interval[0]), v.range(cell.interval[1])};
}

Cell PairedSurfaces::cellAt(const LayoutPlace& place) const {
    const auto& along = pieces_[0][place.patch].along;
    return {place.patch, {along[0].intervalAt(place.at[0]), along[1].intervalAt(place.at[1])}};
}

void PairedSurfaces::get(std::size_t surface, const Cell& cell, BezierPiece& piece) const {
    pieces_[surface][cell.patch].get(cell.interval[0], cell.interval[1], piece);
}

std::optional<PairedSurfaces::Crossing> PairedSurfaces::across(const LayoutPlace& place, int side) const {
    const std::size_t direction = directionAlong(side);
    const int length = layout_.segments[place.patch].size[direction];
    const double along = alongSide<double>(side, place.at[direction], length);
    const int position = std::clamp(static_cast<int>(along), 0, length - 1);
    const auto& [other, gapless] = beyond_[place.patch][at(side)][at(position)];
    if (!other) return std::nullopt;
    const double there = other->position + 1 - std::clamp(along - position, 0.0, 1.0);
    return Crossing{{other->patch, placeOnSide(extent(other->patch), other->side, there)},
                    (other->side - side + 6) % 4,
                    gapless};
}

const BezierPiece& LastPiece::operator()(std::size_t surface, const Cell& cell) {
    if (surface_ != surface || cell_ != cell) surfaces_.get(surface, cell, piece_);
    surface_ = surface;
    cell_ = cell;
    return piece_;
}

} // namespace qm
