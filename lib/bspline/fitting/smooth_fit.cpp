#include "bspline/fitting/smooth_fit.h"

#include "bspline/fitting/fit_attempt.h"
#include "bspline/network/stretches.h"
#include "mesh/bounding_box.h"

#include <utility>

namespace qm {
namespace {

/// Whether all patches are within the tolerance, but for the uncertainty of a verification.
bool isNear(const Fitted& fitted) {
    constexpr double uncertain = 1.02;
    return fitted.farthest() <= uncertain;
}

/// The patches that miss the tolerance, with so many rings of patches around them.
std::vector<bool> missing(const Fitted& fitted, const FitProblem& problem, int rings) {
    std::vector<bool> misses;
    for (const double distance : fitted.round.distances)
        misses.push_back(distance > 1);
    return withNeighbours(problem.network.stretches, std::move(misses), rings);
}

std::vector<Patch> fitWhereItIs(const FitProblem& problem, const SmoothFitOptions& options,
                                const Control& control) {
    Fitted nearest = attemptFit(problem, options, {}, !options.restarts, control);
    // Stiff patches are fair, but where quads fold or are much narrower than their neighbours they can
    // prevent everything around from following the reference, and so can sliding.
    SmoothFitOptions closer = options;
    closer.slack = 0;
    closer.slides = options.slides / 2;
    constexpr int maxRings = 3;
    for (int rings = 1; rings <= maxRings; ++rings, closer.slides = 1) {
        if (!options.restarts || isNear(nearest) || nearest.isHopeless() || control.stopRequested()) break;
        const Restart restart{nearest, missing(nearest, problem, rings)};
        Fitted fitted = attemptFit(problem, closer, restart, rings == maxRings, unreported(control));
        if (fitted.farthest() < nearest.farthest()) nearest = std::move(fitted);
    }
    return std::move(nearest.round.patches);
}

void move(std::vector<Patch>& patches, const Point& by) {
    for (Patch& patch : patches)
        for (Point& point : patch.controlPoints)
            point += by;
}

/// Moves everything to the origin meanwhile.
std::vector<Patch> fitAround(const Point& centre, const FitProblem& problem, const SmoothFitOptions& options,
                             const Control& control) {
    QuadMesh mesh = problem.mesh;
    for (const VertexId vertex : mesh.vertices())
        mesh.point(vertex) -= centre;
    FitTarget reference = problem.reference;
    for (ReferenceGrid& grid : reference.grids)
        for (Point& point : grid.points)
            point -= centre;
    const Verification verify = [&](std::vector<Patch> patches) {
        move(patches, centre);
        return problem.verify(patches);
    };
    std::vector<Patch> patches =
        fitWhereItIs({mesh, problem.layout, problem.network, reference, verify}, options, control);
    move(patches, centre);
    return patches;
}

} // namespace

std::vector<Patch> fitSmooth(const FitProblem& problem, const SmoothFitOptions& options,
                             const Control& control) {
    if (problem.layout.segments.empty()) return {};
    const BoundingBox box = boundingBox(problem.mesh);
    const bool isFarAway = box.centre().norm() > box.diagonal();
    return isFarAway ? fitAround(box.centre(), problem, options, control)
                     : fitWhereItIs(problem, options, control);
}

} // namespace qm
