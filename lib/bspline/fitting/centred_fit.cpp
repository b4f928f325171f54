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

std::vector<Patch> fitCentred(const QuadMesh& mesh, const Layout& layout, const SmoothNetwork& network,
                              const FitTarget& reference, const SmoothFitOptions& options,
                              const Verification& verify, const Control& control) {
    const BoundingBox box = boundingBox(mesh);
    const Point centre = 0.5 * (box.low + box.high);
    if (!(centre.norm() > box.diagonal()))
        return fitSmooth(mesh, layout, network, reference, options, verify, control);
    QuadMesh movedMesh = mesh;
    for (const VertexId vertex : movedMesh.vertices())
        movedMesh.set_point(vertex, mesh.point(vertex) - centre);
    FitTarget movedReference = reference;
    for (ReferenceGrid& grid : movedReference.grids)
        for (Point& point : grid.points)
            point -= centre;
    const Verification verifyInPlace = [&](const std::vector<Patch>& patches) {
        std::vector<Patch> inPlace = patches;
        move(inPlace, centre);
        return verify(inPlace);
    };
    std::vector<Patch> patches =
        fitSmooth(movedMesh, layout, network, movedReference, options, verifyInPlace, control);
    move(patches, centre);
    return patches;
}

} // namespace qm
