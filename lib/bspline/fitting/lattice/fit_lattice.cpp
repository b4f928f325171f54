#include "bspline/fitting/lattice/fit_lattice.h"

#include "base/at.h"
#include "base/parallel.h"
#include "base/positions.h"
#include "bspline/fitting/lattice/folded_normals.h"
#include "bspline/reference/lattice/sound_faces.h"
#include "bspline/splines/evaluate.h"
#include "layout/sides.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace qm {
namespace {

/// Factor of a point's weight where the reference folds over a sound quad.
constexpr double ofGuesses = 0.05;

/// Factor of a point's weight. Points of a crease stand for half a cell, those of corners for a quarter or
/// less, and nothing but them draws a curve to its place: where they weigh no more than others, the fit
/// uses up the whole tolerance at creases and corners, and then needs knots to get back.
double factorOf(Freedom freedom) {
    constexpr double ofCreases = 2;
    constexpr double ofCorners = 16;
    switch (freedom) {
    case Freedom::crease:
        return ofCreases;
    case Freedom::corner:
        return ofCorners;
    default:
        return 1;
    }
}

/// The share of a direction that each of its parameters represents.
std::vector<double> widths(const std::vector<double>& parameters) {
    std::vector<double> result(parameters.size());
    for (std::size_t k = 0; k + 1 < parameters.size(); ++k) {
        const double half = (parameters[k + 1] - parameters[k]) / 2;
        result[k] += half;
        result[k + 1] += half;
    }
    return result;
}

/// Marks the points of a side that lie on creases, and the corners at its ends.
void markSide(const LatticeSource& source, int side, const std::vector<SurfacePoint>& points,
              FitLattice& lattice) {
    const std::size_t along = directionAlong(side);
    const auto& parameters = lattice.targets.parameters[along];
    const auto& isCrease = source.isCrease[at(side)];
    const std::size_t last = parameters.size() - 1;
    for (std::size_t k = 0; k <= last; ++k) { // counter-clockwise
        const std::size_t place = alongSide(side, k, last);
        const double walked = alongSide(side, parameters[place], parameters[last]);
        const auto before = static_cast<std::size_t>(std::max(std::ceil(walked) - 1, 0.0));
        const auto after = std::min(static_cast<std::size_t>(walked), isCrease.size() - 1);
        if (!isCrease[before] && !isCrease[after]) continue;
        const std::size_t point = pointOnSide({lattice.columns(), lattice.rows()}, side, place);
        const bool isEnd = k == 0 || k == last;
        const VertexRule::Kind end = source.corners[at(k == 0 ? side : (side + 1) % 4)];
        if (isEnd && end == VertexRule::Kind::corner) lattice.freedom[point] = Freedom::corner;
        const bool onCurve = !isEnd || end == VertexRule::Kind::crease;
        if (!onCurve || lattice.freedom[point] == Freedom::corner) continue;
        lattice.freedom[point] = Freedom::crease;
        lattice.axes[point] = unit(along == 0 ? points[point].du : points[point].dv);
    }
}

/// The place of a parameter in a coarser list: its interval, and how far it lies within it.
struct Place {
    std::size_t first = 0;
    double share = 0;
};

std::vector<Place> placesIn(const std::vector<double>& coarse, const std::vector<double>& fine) {
    std::vector<Place> places;
    for (const double at : fine) {
        const auto after = std::ranges::upper_bound(coarse, at);
        const auto first = std::min(positionIn(coarse, after), coarse.size() - 1) - 1;
        places.push_back({first, (at - coarse[first]) / (coarse[first + 1] - coarse[first])});
    }
    return places;
}

/// The rule of a segment's corner. Where a crease ends on the curve that the vertex's rule follows, the end
/// of that crease does not slide along the curve.
VertexRule::Kind cornerRule(const QuadMesh& mesh, const Segment& segment, std::size_t side,
                            const SmoothNetwork& network) {
    const VertexId vertex = segment.sides[side].front();
    const VertexRule& rule = network.rules[at(vertex)];
    const auto endsHere = [&](VertexId next) {
        const HalfedgeId halfedge = mesh.find_halfedge(vertex, next);
        return network.marks.isCrease[at(mesh.edge_handle(halfedge))] && !rule.onward(halfedge).is_valid();
    };
    const auto& before = segment.sides[(side + 3) % 4];
    const bool isEnd = rule.kind == VertexRule::Kind::crease &&
                       (endsHere(segment.sides[side][1]) || endsHere(before[before.size() - 2]));
    return isEnd ? VertexRule::Kind::corner : rule.kind;
}

} // namespace

std::vector<LatticeSource> latticeSources(const QuadMesh& mesh, const Layout& layout,
                                          const SmoothNetwork& network, const FitTarget& reference,
                                          unsigned jobs) {
    std::vector<LatticeSource> sources(reference.grids.size());
    constexpr int ringsOfStiff = 2;
    const std::vector<bool> isSound = soundFaces(mesh, jobs);
    const std::vector<bool> isStiff = shrunk(mesh, isSound, ringsOfStiff);
    parallelFor(sources.size(), jobs, [&](std::size_t k) {
        const Segment& segment = layout.segments[k];
        sources[k].grid = &reference.grids[k];
        if (!reference.weights.empty()) sources[k].weights = &reference.weights[k];
        for (const FaceId face : segment.faces) {
            sources[k].isSound.push_back(isSound[at(face)]);
            sources[k].isStiff.push_back(isStiff[at(face)]);
        }
        for (std::size_t side = 0; side < 4; ++side) {
            const auto& vertices = segment.sides[side];
            for (std::size_t i = 0; i + 1 < vertices.size(); ++i) {
                const EdgeId edge = mesh.edge_handle(mesh.find_halfedge(vertices[i], vertices[i + 1]));
                sources[k].isCrease[side].push_back(network.marks.isCrease[at(edge)]);
            }
            sources[k].corners[side] = cornerRule(mesh, segment, side, network);
        }
    });
    return sources;
}

std::vector<double> latticeParameters(int size, int steps, const std::vector<double>& knots) {
    constexpr int places = 4;
    std::vector<double> uniform;
    for (int k = 0; k <= size * steps; ++k)
        uniform.push_back(static_cast<double>(k) / steps);
    std::vector<double> fine;
    for (std::size_t k = 0; k + 1 < knots.size(); ++k) {
        const double length = knots[k + 1] - knots[k];
        if (length <= 0 || length * steps >= places) continue;
        for (int place = 0; place <= places; ++place)
            fine.push_back(knots[k] + length * place / places);
    }
    std::vector<double> all;
    std::ranges::set_union(uniform, fine, std::back_inserter(all));
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

FitLattice makeLattice(const LatticeSource& source, const std::array<std::vector<double>, 2>& parameters) {
    FitLattice lattice;
    lattice.targets.parameters = parameters;
    const auto points = source.grid->evaluateLattice(parameters[0], parameters[1]);
    lattice.reference.reserve(points.size());
    lattice.normals.reserve(points.size());
    lattice.jacobian.reserve(points.size());
    lattice.edge.reserve(points.size());
    for (const SurfacePoint& point : points) {
        lattice.reference.push_back(point.position);
        lattice.normals.push_back(point.normal());
        lattice.jacobian.push_back((point.du % point.dv).norm());
        lattice.edge.push_back(std::sqrt(std::min(point.du.sqrnorm(), point.dv.sqrnorm())));
    }
    lattice.axes = lattice.normals;
    lattice.isGuess.assign(points.size(), false);
    mendFoldedNormals(source, lattice);
    lattice.targets.points = lattice.reference;
    lattice.freedom.assign(points.size(), Freedom::surface);
    lattice.emphasis.assign(points.size(), 1);
    lattice.slides.assign(points.size(), Point(0, 0, 0));
    lattice.holds.assign(points.size(), 0);
    lattice.isHeld.assign(points.size(), false);
    for (int side = 0; side < 4; ++side)
        markSide(source, side, points, lattice);
    weighTargets(source, lattice);
    return lattice;
}

FitLattice restored(const LatticeSource& source, const LatticeProgress& progress) {
    FitLattice lattice = makeLattice(source, progress.targets.parameters);
    static_cast<LatticeProgress&>(lattice) = progress;
    return lattice;
}

FitLattice resample(const LatticeSource& source, const FitLattice& before,
                    const std::array<std::vector<double>, 2>& parameters) {
    FitLattice lattice = makeLattice(source, parameters);
    const auto us = placesIn(before.targets.parameters[0], parameters[0]);
    const auto vs = placesIn(before.targets.parameters[1], parameters[1]);
    for (std::size_t j = 0; j < vs.size(); ++j)
        for (std::size_t i = 0; i < us.size(); ++i) {
            const std::size_t k = j * us.size() + i;
            Point slide(0, 0, 0);
            Point ahead(0, 0, 0);
            double emphasis = 1;
            for (const std::size_t dj : {0U, 1U})
                for (const std::size_t di : {0U, 1U}) {
                    const double share =
                        (di == 0 ? 1 - us[i].share : us[i].share) * (dj == 0 ? 1 - vs[j].share : vs[j].share);
                    if (share == 0) continue;
                    const std::size_t from = (vs[j].first + dj) * before.columns() + us[i].first + di;
                    slide += share * before.slides[from];
                    ahead += share * (before.targets.points[from] - before.reference[from]);
                    emphasis = std::max(emphasis, before.emphasis[from]);
                    lattice.holds[k] = std::max(lattice.holds[k], before.holds[from]);
                }
            lattice.emphasis[k] = emphasis;
            if (lattice.holds[k] >= maxHolds || lattice.freedom[k] == Freedom::corner) continue;
            lattice.slides[k] = slide;
            lattice.targets.points[k] = lattice.reference[k] + ahead;
        }
    weighTargets(source, lattice);
    return lattice;
}

void weighTargets(const LatticeSource& source, FitLattice& lattice) {
    const auto us = widths(lattice.targets.parameters[0]);
    const auto vs = widths(lattice.targets.parameters[1]);
    auto& weights = lattice.targets.weights;
    weights.clear();
    weights.reserve(lattice.emphasis.size());
    const ReferenceGrid& grid = *source.grid;
    const auto nearest = [&](double parameter) { return at(std::lround(parameter * grid.steps)); };
    for (std::size_t j = 0; j < vs.size(); ++j)
        for (std::size_t i = 0; i < us.size(); ++i) {
            double weight = us[i] * vs[j] * lattice.emphasis[weights.size()];
            if (lattice.isGuess[weights.size()]) weight *= ofGuesses;
            weight *= factorOf(lattice.freedom[weights.size()]);
            if (source.weights != nullptr)
                weight *= (*source.weights)[nearest(lattice.targets.parameters[1][j]) * grid.columns() +
                                            nearest(lattice.targets.parameters[0][i])];
            weights.push_back(weight);
        }
}

} // namespace qm
