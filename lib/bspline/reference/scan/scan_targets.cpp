#include "bspline/reference/scan/scan_targets.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace qm {

ScanTargets::ScanTargets(const LatticeNormals& ofLattice, const std::vector<ReferenceGrid>& ofSurface,
                         std::vector<Displacement> ofPoints)
    : lattice(ofLattice), surface(ofSurface), displacements(std::move(ofPoints)) {
    weights.reserve(displacements.size());
    for (const Displacement& displacement : displacements)
        weights.push_back(displacement ? 1.0 : 0.0);
}

std::optional<std::size_t> ScanTargets::numberAt(std::size_t g, int i, int j) const {
    if (i < 0 || j < 0 || i > columns(g) || j > rows(g)) return std::nullopt;
    return lattice.numbers[g][index(g, i, j)];
}

std::optional<double> ScanTargets::offset(std::size_t g, int i, int j) const {
    const auto number = numberAt(g, i, j);
    if (!number || weights[*number] <= 0 || lattice.sharp[*number]) return std::nullopt;
    return displacements[*number]->dot(*lattice.oneSided[g][index(g, i, j)]);
}

int ScanTargets::stepsOfGrain() const {
    return static_cast<int>(std::clamp(std::ceil(grain), 1.0, static_cast<double>(surface.front().steps)));
}

double ScanTargets::coverage() const {
    double all = 0;
    double covered = 0;
    for (std::size_t k = 0; k < weights.size(); ++k) {
        if (!lattice.normals[k]) continue;
        ++all;
        covered += weights[k] > 0 ? 1 : 0;
    }
    return all > 0 ? covered / all : 0;
}

FitTarget ScanTargets::result() const {
    FitTarget result{surface, {}};
    for (const ReferenceGrid& grid : surface)
        result.weights.emplace_back(grid.points.size());
    forEachPoint([&](std::size_t g, int i, int j, std::size_t number) {
        if (weights[number] <= 0) return;
        result.grids[g].points[index(g, i, j)] = point(lattice.points[number] + *displacements[number]);
        result.weights[g][index(g, i, j)] = weights[number];
    });
    result.noise = noise;
    return result;
}

void ScanTargets::update(const FitTarget& result) {
    forEachPoint([&](std::size_t g, int i, int j, std::size_t number) {
        const std::size_t at = index(g, i, j);
        displacements[number] = vector(result.grids[g].points[at]) - lattice.points[number];
        weights[number] = result.weights[g][at];
    });
}

} // namespace qm
