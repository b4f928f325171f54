#include "bspline/fitting/centred_fit.h"

#include "mesh/bounding_box.h"

#include <utility>

namespace qm {
namespace {

void move(std::vector<Patch>& patches, const Point& by) {
    for (Patch& patch : patches)
        for (Point& point : patch.controlPoints)
            point += by;
}

} // namespace

std::vector<Patch> fitCentred(const FitProblem& problem, const SmoothFitOptions& options,
                              const Control& control) {
    const BoundingBox box = boundingBox(problem.mesh);
    const Point centre = box.centre();
    if (!(centre.norm() > box.diagonal())) return fitSmooth(problem, options, control);
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
        fitSmooth({mesh, problem.layout, problem.network, reference, verify}, options, control);
    move(patches, centre);
    return patches;
}

} // namespace qm
