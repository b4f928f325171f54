#include "base/at.h"
#include "shape/sample_meshes.h"

#include <cmath>
#include <map>
#include <numbers>

namespace qm {
namespace {

constexpr double fullTurn = 2 * std::numbers::pi;

struct Ring {
    GridTopology grid; ///< columns go around the tube, rows along the ring
    double radius = 3; ///< of the tube's middle
    double thickness = 1;

    /// \param height  above the tube's surface
    [[nodiscard]] Point at(int column, int row, double height) const {
        const double along = static_cast<double>(row) / grid.rows;
        const double around = (column + grid.shift * along) / grid.columns;
        const double theta = fullTurn * around, phi = fullTurn * along;
        const double tube = thickness + height;
        const double out = radius + tube * std::cos(theta);
        return {out * std::cos(phi), out * std::sin(phi), -tube * std::sin(theta)};
    }
};

QuadList surfaceOf(const Ring& ring) {
    return ring.grid.withPoints([&](int column, int row) { return ring.at(column, row, 0); });
}

/// Lifts the quads of `size` columns and rows from the given ones on, and puts walls of `levels` quads
/// around them. Vertices inside are lifted, those on the rim are doubled.
void raiseBoss(QuadList& list, const Ring& ring, int firstColumn, int firstRow, int size, int levels) {
    const double step = fullTurn * ring.thickness / ring.grid.columns;
    std::map<std::array<int, 3>, int> numbers;
    const auto vertex = [&](int column, int row, int level) {
        const int below = ring.grid.vertex(column, row);
        const bool inside =
            column > firstColumn && column < firstColumn + size && row > firstRow && row < firstRow + size;
        if (inside) list.points[at(below)] = ring.at(column, row, level * step);
        if (inside || level == 0) return below;
        const auto [entry, isNew] =
            numbers.try_emplace({column, row, level}, static_cast<int>(list.points.size()));
        if (isNew) list.points.push_back(ring.at(column, row, level * step));
        return entry->second;
    };
    for (int j = 0; j < size; ++j)
        for (int i = 0; i < size; ++i) {
            const int column = firstColumn + i, row = firstRow + j;
            const auto quad = at(row) * at(ring.grid.columns) + at(column);
            list.quads[quad] = {vertex(column, row, levels), vertex(column + 1, row, levels),
                                vertex(column + 1, row + 1, levels), vertex(column, row + 1, levels)};
        }
    const int lastColumn = firstColumn + size, lastRow = firstRow + size;
    const auto wall = [&](int column, int row, int nextColumn, int nextRow) {
        for (int level = 0; level < levels; ++level)
            list.quads.push_back({vertex(column, row, level), vertex(nextColumn, nextRow, level),
                                  vertex(nextColumn, nextRow, level + 1), vertex(column, row, level + 1)});
    };
    for (int k = 0; k < size; ++k) {
        wall(firstColumn + k, firstRow, firstColumn + k + 1, firstRow);
        wall(lastColumn, firstRow + k, lastColumn, firstRow + k + 1);
        wall(lastColumn - k, lastRow, lastColumn - k - 1, lastRow);
        wall(firstColumn, lastRow - k, firstColumn, lastRow - k - 1);
    }
}

} // namespace

QuadList tubeShape(int around) {
    const GridTopology grid{.columns = around, .rows = 3 * around / 2, .columnsClosed = true};
    return grid.withPoints([&](int column, int row) {
        const double theta = fullTurn * column / grid.columns;
        return Point(std::cos(theta), std::sin(theta), 6.0 * row / grid.rows);
    });
}

QuadList torusShape(int around) {
    const GridTopology grid{.columns = around, .rows = 3 * around, .columnsClosed = true, .rowsClosed = true};
    return surfaceOf({.grid = grid});
}

QuadList helixShape(int n) {
    // A shift without a common divisor with the columns makes one line of all threads.
    const GridTopology grid{
        .columns = 4 * n, .rows = 12 * n, .columnsClosed = true, .rowsClosed = true, .shift = 2 * n - 1};
    const Ring ring{.grid = grid};
    QuadList list = surfaceOf(ring);
    raiseBoss(list, ring, 0, n, n, (n + 1) / 2);
    return list;
}

} // namespace qm
