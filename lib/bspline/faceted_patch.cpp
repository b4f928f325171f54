#include "bspline/faceted_patch.h"

#include "bspline/mesh_distance.h"
#include "bspline/patch_frame.h"

#include <algorithm>
#include <utility>

namespace qm {
namespace {

std::vector<double> tripleKnots(int edges) {
    std::vector<double> knots(4, 0);
    for (int k = 1; k < edges; ++k)
        knots.insert(knots.end(), 3, k);
    knots.insert(knots.end(), 4, edges);
    return knots;
}

} // namespace

Patch facetedPatch(const PatchFitInput& input) {
    const std::array<std::vector<double>, 2> quads = {tripleKnots(input.size[0]), tripleKnots(input.size[1])};
    std::array<std::vector<double>, 2> knots;
    for (std::size_t d = 0; d < 2; ++d)
        knots[d] = commonKnots(quads[d], commonKnots(input.border[d][0].knots, input.border[d][1].knots));
    Patch patch = emptyPatch(std::move(knots[0]), std::move(knots[1]));
    const auto width = static_cast<std::size_t>(input.size[0]) + 1;
    const std::size_t columns = quads[0].size() - 4;
    const std::size_t rows = quads[1].size() - 4;
    const auto finerColumns = static_cast<std::size_t>(patch.count[0]);
    SplineCurve line;
    std::vector<std::vector<Point>> finer;
    line.knots = quads[0];
    line.points.resize(columns);
    for (std::size_t j = 0; j < rows; ++j) {
        for (std::size_t i = 0; i < columns; ++i) {
            const std::size_t column = std::min(i / 3, width - 2);
            const std::size_t row = std::min(j / 3, static_cast<std::size_t>(input.size[1]) - 1);
            const Point* corner = input.grid.data() + row * width + column;
            line.points[i] = bilinear({corner[0], corner[1], corner[width + 1], corner[width]},
                                      static_cast<double>(i) / 3 - static_cast<double>(column),
                                      static_cast<double>(j) / 3 - static_cast<double>(row));
        }
        finer.push_back(withKnots(line, patch.knots[0]).points);
    }
    line.knots = quads[1];
    line.points.resize(rows);
    for (std::size_t i = 0; i < finerColumns; ++i) {
        for (std::size_t j = 0; j < rows; ++j)
            line.points[j] = finer[j][i];
        const auto points = withKnots(line, patch.knots[1]).points;
        for (std::size_t j = 0; j < points.size(); ++j)
            patch.controlPoints[j * finerColumns + i] = points[j];
    }
    setBorder(patch, {input.border[0], input.border[1], {}, {}});
    return patch;
}

} // namespace qm
