#include "bspline/fitting/lattice/lattice_holds.h"

#include "base/positions.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace qm {
namespace {

struct Interval {
    std::size_t begin = 0;
    std::size_t end = 0;
};

/// Of the parameters up to one edge away.
Interval positionsAround(const std::vector<double>& parameters, double at) {
    return {positionIn(parameters, std::ranges::lower_bound(parameters, at - 1)),
            positionIn(parameters, std::ranges::upper_bound(parameters, at + 1))};
}

void hold(std::size_t point, int times, FitLattice& lattice) {
    lattice.isHeld[point] = true;
    lattice.holds[point] = static_cast<char>(std::min(lattice.holds[point] + times, maxHolds));
    lattice.slides[point] = Point(0, 0, 0);
    lattice.targets.points[point] = lattice.reference[point];
}

/// Counts marks in rectangles, each in constant time.
class RectangleCounts {
public:
    RectangleCounts(const std::vector<bool>& marks, std::size_t columns)
        : width_(columns + 1), sums_((marks.size() / columns + 1) * width_) {
        for (std::size_t k = 0; k < marks.size(); ++k) {
            const std::size_t at = (k / columns + 1) * width_ + k % columns + 1;
            sums_[at] = sums_[at - 1] + sums_[at - width_] - sums_[at - width_ - 1] + (marks[k] ? 1 : 0);
        }
    }

    [[nodiscard]] int operator()(const Interval& columns, const Interval& rows) const {
        return sum(columns.end, rows.end) - sum(columns.begin, rows.end) - sum(columns.end, rows.begin) +
               sum(columns.begin, rows.begin);
    }

private:
    [[nodiscard]] int sum(std::size_t column, std::size_t row) const { return sums_[row * width_ + column]; }

    std::size_t width_;
    std::vector<int> sums_; ///< number of marks before a column and a row
};

/// By lattice point: whether it lies in any of the rectangles. There may be as many as points, each with many
/// points: so only their corners are visited.
std::vector<bool> pointsIn(const std::vector<KnotCell>& rectangles, const FitLattice& lattice) {
    const std::size_t columns = lattice.columns();
    const std::size_t width = columns + 1;
    // How many rectangles more a point is in than those before it in its row and column.
    std::vector<int> more(width * (lattice.reference.size() / columns + 1));
    for (const KnotCell& rectangle : rectangles) {
        const auto [begin, end] = rangeOf(rectangle, lattice);
        ++more[begin[1] * width + begin[0]];
        --more[begin[1] * width + end[0]];
        --more[end[1] * width + begin[0]];
        ++more[end[1] * width + end[0]];
    }
    std::vector<bool> isWithin;
    std::vector<int> ofColumn(columns); // of `more`, in all rows so far
    for (std::size_t row = 0; isWithin.size() < lattice.reference.size(); ++row) {
        int rectanglesHere = 0;
        for (std::size_t column = 0; column < columns; ++column) {
            ofColumn[column] += more[row * width + column];
            rectanglesHere += ofColumn[column];
            isWithin.push_back(rectanglesHere > 0);
        }
    }
    return isWithin;
}

} // namespace

void holdAroundFolds(const std::vector<bool>& isFolded, FitLattice& lattice) {
    if (std::ranges::find(isFolded, true) == isFolded.end()) return;
    const RectangleCounts folds(isFolded, lattice.columns());
    std::array<std::vector<Interval>, 2> around; // by column and by row
    for (std::size_t k = 0; k < 2; ++k)
        for (const double at : lattice.targets.parameters[k])
            around[k].push_back(positionsAround(lattice.targets.parameters[k], at));
    std::size_t point = 0;
    for (const Interval& rows : around[1])
        for (const Interval& columns : around[0]) {
            if (const int times = folds(columns, rows); times > 0) hold(point, times, lattice);
            ++point;
        }
}

bool holdTargets(const std::vector<KnotCell>& rectangles, FitLattice& lattice) {
    const std::vector<bool> isWithin = pointsIn(rectangles, lattice);
    bool isNew = false;
    for (std::size_t point = 0; point < isWithin.size(); ++point) {
        if (!isWithin[point]) continue;
        isNew = isNew || lattice.holds[point] < maxHolds;
        hold(point, maxHolds, lattice);
    }
    return isNew;
}

void releaseHolds(FitLattice& lattice) {
    for (std::size_t k = 0; k < lattice.holds.size(); ++k)
        lattice.isHeld[k] = lattice.holds[k] >= maxHolds;
}

} // namespace qm
