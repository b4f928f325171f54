#include "bspline/fitting/lattice/lattice_holds.h"

#include "base/positions.h"
#include "bspline/fitting/lattice/lattice_cells.h"

#include <algorithm>
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

bool holdTargets(const std::array<double, 2>& begin, const std::array<double, 2>& end, FitLattice& lattice) {
    bool isNew = false;
    forPoints({begin, end}, lattice, [&](std::size_t point) {
        isNew = isNew || lattice.holds[point] < maxHolds;
        hold(point, maxHolds, lattice);
    });
    return isNew;
}

void releaseHolds(FitLattice& lattice) {
    for (std::size_t k = 0; k < lattice.holds.size(); ++k)
        lattice.isHeld[k] = lattice.holds[k] >= maxHolds;
}

} // namespace qm
