#include "bspline/measure/max_deviations.h"

#include "base/parallel.h"
#include "bspline/measure/certified_deviation.h"
#include "bspline/measure/paired_surfaces.h"

#include <cstddef>
#include <utility>

namespace qm {
namespace {

/// The foot of a point may lie in a neighbour of its patch, or across a vertex.
constexpr int rings = 3;

bool isSame(const Patch& one, const Patch& other) {
    return one.knots == other.knots && one.controlPoints == other.controlPoints;
}

} // namespace

MaxDeviations::MaxDeviations(const QuadMesh& mesh, const Layout& layout,
                             const std::vector<ReferenceGrid>& references, double limit, unsigned jobs)
    : layout_(layout), references_(references), limit_(limit), jobs_(jobs),
      borders_(borderEdges(mesh, layout)), stretches_(findStretches(borders_)) {}

std::vector<double> MaxDeviations::operator()(const std::vector<Patch>& patches) {
    const std::vector<bool> isNew = changed(patches);
    const PairedSurfaces pairs(layout_, patches, references_, borders_, jobs_);
    constexpr double closing = 0.05; // a rough bound will do above the limit
    distances_.resize(patches.size());
    parallelFor(patches.size(), jobs_, [&](std::size_t k) {
        if (isNew[k])
            distances_[k] = certifiedDeviation(pairs, k, {.closing = closing, .negligible = limit_}).upper;
    });
    measured_ = patches;
    return distances_;
}

std::vector<bool> MaxDeviations::changed(const std::vector<Patch>& patches) const {
    std::vector<bool> isChanged(patches.size(), true);
    if (measured_.empty()) return isChanged;
    for (std::size_t k = 0; k < patches.size(); ++k)
        isChanged[k] = !isSame(patches[k], measured_[k]);
    return withNeighbours(stretches_, std::move(isChanged), rings);
}

} // namespace qm
