#include "bspline/fitting/knots/uneven_lines.h"

#include <array>
#include <cstddef>

namespace qm {
namespace {

/// Up to this, a spline changes its speed in time: reference surfaces change theirs by three times at most.
constexpr double maxRatio = 5;

/// The widths of the strips of quads between successive grid lines, each the sum over all lines across it.
std::vector<double> stripWidths(const ReferenceGrid& grid, std::size_t direction) {
    std::vector<double> widths;
    for (int strip = 0; strip < grid.size[direction]; ++strip) {
        double width = 0;
        for (int line = 0; line <= grid.size[1 - direction]; ++line) {
            const auto vertex = [&](int k) -> const Point& {
                return direction == 0 ? grid.vertex(k, line) : grid.vertex(line, k);
            };
            width += (vertex(strip + 1) - vertex(strip)).norm();
        }
        widths.push_back(width);
    }
    return widths;
}

} // namespace

KnotLists unevenLines(const std::vector<ReferenceGrid>& grids) {
    KnotLists lines;
    for (const ReferenceGrid& grid : grids) {
        auto& ofPatch = lines.emplace_back();
        for (const std::size_t direction : {0U, 1U}) {
            const std::vector<double> widths = stripWidths(grid, direction);
            for (std::size_t k = 1; k < widths.size(); ++k)
                if (widths[k] > maxRatio * widths[k - 1] || widths[k - 1] > maxRatio * widths[k])
                    ofPatch[direction].push_back(static_cast<double>(k));
        }
    }
    return lines;
}

} // namespace qm
