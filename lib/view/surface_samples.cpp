#include "view/surface_samples.h"

#include "base/at.h"
#include "base/parallel.h"
#include "bspline/measure/border_measures.h"
#include "bspline/measure/foot_search.h"
#include "bspline/reference/limit_surface.h"
#include "bspline/splines/eigen_point.h"
#include "bspline/splines/evaluate.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace qm {
namespace {

std::vector<BasisValues> basisOnLattice(const Patch& patch, std::size_t direction, std::size_t steps) {
    const auto [begin, end] = domain(patch.knots[direction], patch.degree[direction]);
    const auto count = static_cast<std::size_t>(std::lround(end - begin)) * steps;
    std::vector<double> parameters(count + 1);
    for (std::size_t k = 0; k <= count; ++k)
        parameters[k] = static_cast<double>(k) / static_cast<double>(steps);
    return basisTable(patch.knots[direction], patch.degree[direction], parameters);
}

} // namespace

std::size_t latticeSteps(std::size_t faces) {
    constexpr double maxPoints = 120'000; // what is drawn at ease without a graphics card
    constexpr double finest = 8;          // an edge: more is seen on no screen
    return static_cast<std::size_t>(std::clamp(
        std::floor(std::sqrt(maxPoints / std::max(1.0, static_cast<double>(faces)))), 1.0, finest));
}

std::vector<double> distancesFromReference(const QuadMesh& mesh, const Layout& layout,
                                           const std::vector<Patch>& patches, const BorderMarks& marks,
                                           std::size_t steps, unsigned jobs) {
    constexpr int referenceSteps = 4; // an edge, as those of the fit
    constexpr std::size_t reference = 1;
    const auto grids = limitSurface(mesh, layout, marks.isCrease, referenceSteps, jobs);
    const auto borders = borderEdges(mesh, layout);
    const PairedSurfaces surfaces(layout, patches, grids, borders);
    std::vector<std::vector<double>> ofPatch(patches.size());
    parallelFor(patches.size(), jobs, [&](std::size_t k) {
        FootSearch search(surfaces);
        const auto us = basisOnLattice(patches[k], 0, steps);
        const auto vs = basisOnLattice(patches[k], 1, steps);
        const auto points = positionLattice(patches[k], us, vs);
        ofPatch[k].reserve(points.size());
        for (std::size_t i = 0; i < points.size(); ++i) {
            const auto at = [&](std::size_t number) {
                return static_cast<double>(number) / static_cast<double>(steps);
            };
            const LayoutPlace place{k, {at(i % us.size()), at(i / us.size())}};
            ofPatch[k].push_back(search(reference, place, vector(points[i])).distance);
        }
    });
    std::vector<double> distances;
    for (const auto& some : ofPatch)
        distances.insert(distances.end(), some.begin(), some.end());
    return distances;
}

std::vector<double> normalAngles(const QuadMesh& mesh, const Layout& layout,
                                 const std::vector<Patch>& patches, const std::vector<BorderEdge>& borders,
                                 const BorderMarks& marks) {
    constexpr int samples = 5; // an edge: both ends, and three between, as angles change smoothly
    std::vector<double> largest;
    for (const BorderEdge& border : borders) {
        const auto edge = at(mesh.edge_handle(border.halfedge));
        const bool smooth = border.places.size() == 2 && !marks.isCrease[edge];
        const auto angles =
            smooth ? measureBorder(border, layout, patches, samples).angles : std::vector<double>{};
        largest.push_back(angles.empty() ? std::numeric_limits<double>::quiet_NaN()
                                         : *std::max_element(angles.begin(), angles.end()));
    }
    return largest;
}

} // namespace qm
