#include "bspline/fitting/fit_setup.h"

#include "base/parallel.h"
#include "bspline/fitting/knots/border_knots.h"
#include "bspline/fitting/knots/initial_knots.h"
#include "bspline/fitting/knots/reach_alignment.h"
#include "bspline/fitting/knots/uneven_lines.h"

namespace qm {
namespace {

/// How far single cubics between the first knots may be from the reference, in tolerances. A spline with
/// these knots is farther away, because its pieces must fit together.
struct FirstKnots {
    static constexpr double ofPatches = 0.2;
    static constexpr double ofBorders = 0.4;
};

} // namespace

FitSetup::FitSetup(const FitProblem& problem, const SmoothFitOptions& fitOptions,
                   const std::vector<bool>& isSoft, unsigned threads)
    : layout(problem.layout), options(fitOptions), jobs(threads),
      map(problem.mesh, problem.layout, problem.network),
      evenVertices(qm::evenVertices(problem.mesh, problem.network, problem.reference.grids)),
      planWithoutKnots(problem.layout, problem.network,
                       partsOfEdges(problem.reference.grids, options.minInterval * options.tolerance),
                       unevenLines(problem.reference.grids)),
      sources(latticeSources(problem.mesh, problem.layout, problem.network, problem.reference, jobs)),
      normalLimits(problem.reference.grids.begin(), problem.reference.grids.end()) {
    for (std::size_t k = 0; k < sources.size(); ++k) {
        const ReferenceGrid& grid = *sources[k].grid;
        plates.push_back(isSoft[k] ? softPlates(grid.size)
                                   : thinPlates(grid, sources[k].isStiff, options.tolerance));
    }
}

std::array<std::vector<double>, 2>
FitSetup::parametersOf(std::size_t patch, const std::array<std::vector<double>, 2>& knots) const {
    const auto& size = layout.segments[patch].size;
    return {latticeParameters(size[0], options.steps, knots[0]),
            latticeParameters(size[1], options.steps, knots[1])};
}

FitLattice FitSetup::evenLattice(std::size_t patch) const {
    return makeLattice(sources[patch], parametersOf(patch, {}));
}

std::vector<FitLattice> FitSetup::evenLattices() const {
    std::vector<FitLattice> lattices(sources.size());
    parallelFor(sources.size(), jobs, [&](std::size_t k) { lattices[k] = evenLattice(k); });
    return lattices;
}

KnotPlan FitSetup::firstKnots(const std::vector<FitLattice>& lattices,
                              const std::vector<double>& share) const {
    const auto tolerances = [&](double distance) {
        std::vector<double> result = share;
        for (double& ofPatch : result)
            ofPatch *= distance * options.tolerance;
        return result;
    };
    KnotPlan plan = planWithoutKnots;
    insertInitialKnots(lattices, normalLimits, map, tolerances(FirstKnots::ofPatches), plan);
    insertBorderKnots(lattices, normalLimits, tolerances(FirstKnots::ofBorders), plan);
    plan.endAtFirstKnots();
    alignReaches(plan, evenVertices, options.evenBorders * options.tolerance);
    return plan;
}

} // namespace qm
