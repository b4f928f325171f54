#include "shape/quad_list.h"

#include "base/at.h"

#include <cmath>
#include <map>
#include <utility>

namespace qm {
namespace {

/// Numbers the vertices of the finer mesh: the coarse ones, then those on edges, then those in quads.
class Refinement {
public:
    Refinement(const QuadList& coarse, const std::array<int, 3>& n) : coarse_(coarse), n_(n) {
        fine_.points = coarse.points;
    }

    QuadList run() {
        for (const auto& quad : coarse_.quads)
            divide(quad);
        return std::move(fine_);
    }

private:
    void divide(const std::array<int, 4>& quad) {
        const int a = quad[0], b = quad[1], c = quad[2], d = quad[3];
        const int columns = parts(a, b), rows = parts(b, c);
        for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(d, c), std::pair(a, d)})
            (void)onEdge(from, to, 1);
        const int firstInside = static_cast<int>(fine_.points.size());
        for (int j = 1; j < rows; ++j)
            for (int i = 1; i < columns; ++i)
                fine_.points.push_back(between(between(point(a), point(b), i, columns),
                                               between(point(d), point(c), i, columns), j, rows));
        const auto vertex = [&](int i, int j) {
            if (j == 0) return onEdge(a, b, i);
            if (j == rows) return onEdge(d, c, i);
            if (i == 0) return onEdge(a, d, j);
            if (i == columns) return onEdge(b, c, j);
            return firstInside + (j - 1) * (columns - 1) + i - 1;
        };
        for (int j = 0; j < rows; ++j)
            for (int i = 0; i < columns; ++i)
                fine_.quads.push_back(
                    {vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }

    [[nodiscard]] const Point& point(int k) const { return coarse_.points[at(k)]; }

    /// How many parts an edge falls into.
    [[nodiscard]] int parts(int a, int b) const {
        const Point along = point(b) - point(a);
        std::size_t axis = 0;
        for (const std::size_t k : {1U, 2U})
            if (std::abs(along[k]) > std::abs(along[axis])) axis = k;
        return n_[axis];
    }

    /// The same on whichever side of the edge it is asked for.
    static Point between(const Point& a, const Point& b, int k, int n) {
        return (a * static_cast<double>(n - k) + b * static_cast<double>(k)) / static_cast<double>(n);
    }

    int onEdge(int a, int b, int k) {
        const int n = parts(a, b);
        if (k == 0) return a;
        if (k == n) return b;
        if (a > b) return onEdge(b, a, n - k);
        const auto [entry, isNew] = firstOnEdge_.try_emplace({a, b}, static_cast<int>(fine_.points.size()));
        if (isNew)
            for (int i = 1; i < n; ++i)
                fine_.points.push_back(between(point(a), point(b), i, n));
        return entry->second + k - 1;
    }

    const QuadList& coarse_;
    std::array<int, 3> n_;
    QuadList fine_;
    std::map<std::pair<int, int>, int> firstOnEdge_;
};

/// Moves every point by a factor of the way to the mean of its neighbours along edges.
void moveToNeighbours(QuadList& list, double factor) {
    std::vector<Point> sums(list.points.size(), Point(0, 0, 0));
    std::vector<double> counts(list.points.size(), 0);
    for (const auto& quad : list.quads)
        for (std::size_t k = 0; k < 4; ++k) { // inner edges are met from both sides, twice as often
            const std::size_t a = at(quad[k]), b = at(quad[(k + 1) % 4]);
            sums[a] += list.points[b];
            sums[b] += list.points[a];
            counts[a] += 1;
            counts[b] += 1;
        }
    for (std::size_t k = 0; k < sums.size(); ++k)
        list.points[k] += (sums[k] / counts[k] - list.points[k]) * factor;
}

} // namespace

QuadList refined(const QuadList& coarse, int n) {
    return refined(coarse, {n, n, n});
}

QuadList refined(const QuadList& coarse, const std::array<int, 3>& n) {
    return Refinement(coarse, n).run();
}

void soften(QuadList& list, int rounds) {
    for (int round = 0; round < rounds; ++round) {
        moveToNeighbours(list, 0.5);
        moveToNeighbours(list, -0.52);
    }
}

int GridTopology::vertex(int column, int row) const {
    if (rowsClosed && row >= rows) {
        row -= rows;
        column += shift;
    }
    if (columnsClosed) column = (column % columns + columns) % columns;
    return row * width() + column;
}

std::vector<std::array<int, 4>> GridTopology::quads() const {
    std::vector<std::array<int, 4>> result;
    result.reserve(at(columns) * at(rows));
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
            result.push_back({vertex(column, row), vertex(column + 1, row), vertex(column + 1, row + 1),
                              vertex(column, row + 1)});
    return result;
}

} // namespace qm
