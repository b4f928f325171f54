#include "view/surface_samples.h"

#include "base/at.h"
#include "base/parallel.h"
#include "bspline/measure/border_measures.h"
#include "bspline/measure/foot_search.h"
#include "bspline/splines/eigen_point.h"
#include "bspline/splines/evaluate.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace qm {
namespace {

/// The points of a patch on the lattice, row by row.
struct PatchLattice {
    std::size_t columns = 0; ///< points along u
    std::vector<Point> points;
};

PatchLattice latticeOf(const Patch& patch, std::size_t steps) {
    const auto basis = [&](std::size_t direction) {
        const auto [begin, end] = domain(patch.knots[direction], patch.degree[direction]);
        const std::size_t count = at(std::lround(end - begin)) * steps;
        std::vector<double> parameters(count + 1);
        for (std::size_t k = 0; k <= count; ++k)
            parameters[k] = static_cast<double>(k) / static_cast<double>(steps);
        return basisTable(patch.knots[direction], patch.degree[direction], parameters);
    };
    const auto us = basis(0);
    return {us.size(), positionLattice(patch, us, basis(1))};
}

/// One list of what a function says of every patch.
template <class Function>
std::vector<double> ofAllPatches(std::size_t count, unsigned jobs, const Function& ofPatch) {
    std::vector<std::vector<double>> parts(count);
    parallelFor(count, jobs, [&](std::size_t k) { parts[k] = ofPatch(k); });
    std::vector<double> all;
    for (const auto& part : parts)
        all.insert(all.end(), part.begin(), part.end());
    return all;
}

} // namespace

std::size_t latticeSteps(std::size_t faces, std::size_t maxPoints) {
    constexpr double finest = 8; // an edge: more is seen on no screen
    const double ofFace = static_cast<double>(maxPoints) / std::max(1.0, static_cast<double>(faces));
    return static_cast<std::size_t>(std::clamp(std::floor(std::sqrt(ofFace)), 1.0, finest));
}

std::vector<double> distancesFromReference(const MeasuredSurfaces& surfaces, std::size_t steps,
                                           unsigned jobs) {
    constexpr std::size_t referenceSide = 1;
    const auto borders = borderEdges(surfaces.mesh, surfaces.layout);
    const PairedSurfaces pairs(surfaces.layout, surfaces.patches, surfaces.references, borders, jobs);
    return ofAllPatches(surfaces.patches.size(), jobs, [&](std::size_t k) {
        FootSearch search(pairs);
        const auto [columns, points] = latticeOf(surfaces.patches[k], steps);
        const auto at = [&](std::size_t number) {
            return static_cast<double>(number) / static_cast<double>(steps);
        };
        std::vector<double> distances;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const LayoutPlace place{k, {at(i % columns), at(i / columns)}};
            distances.push_back(search(referenceSide, place, vector(points[i])).distance);
        }
        return distances;
    });
}

std::vector<double> distancesFromScan(const std::vector<Patch>& patches, const TriangleSurface& scan,
                                      double cutOff, std::size_t steps, unsigned jobs) {
    return ofAllPatches(patches.size(), jobs, [&](std::size_t k) {
        std::vector<double> distances;
        for (const Point& point : latticeOf(patches[k], steps).points) {
            const auto foot = scan.nearest(point, cutOff);
            const bool shown = foot && !foot->onBoundary;
            distances.push_back(shown ? foot->distance : std::numeric_limits<double>::quiet_NaN());
        }
        return distances;
    });
}

std::vector<double> onLattice(const std::vector<double>& figures, const Layout& layout, std::size_t steps) {
    std::vector<double> values;
    for (std::size_t k = 0; k < figures.size(); ++k) {
        const auto& [columns, rows] = layout.segments[k].size;
        const auto points = (at(columns) * steps + 1) * (at(rows) * steps + 1);
        values.insert(values.end(), points, figures[k]);
    }
    return values;
}

std::vector<double> normalAngles(const QuadMesh& mesh, const Layout& layout,
                                 const std::vector<Patch>& patches, const std::vector<BorderEdge>& borders,
                                 const BorderMarks& marks) {
    constexpr int samples = 5; // an edge: both ends, and three between, as angles change smoothly
    std::vector<double> largest;
    for (const BorderEdge& border : borders) {
        const std::size_t edge = at(mesh.edge_handle(border.halfedge));
        const bool smooth = border.places.size() == 2 && !marks.isCrease[edge];
        const auto angles =
            smooth ? measureBorder(border, layout, patches, samples).angles : std::vector<double>{};
        largest.push_back(angles.empty() ? std::numeric_limits<double>::quiet_NaN()
                                         : std::ranges::max(angles));
    }
    return largest;
}

} // namespace qm
