#include "remesh/polygons/grid_filling.h"

#include "base/sort_unique.h"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <numbers>
#include <utility>

namespace qm {
namespace {

constexpr std::size_t minCorners = 8, maxCorners = 128;
/// A little more than that of a regular polygon of twelve corners, so that rounding does not count.
constexpr double maxTurn = std::numbers::pi / 6 + 1e-9;

/// The rim point at the first corner of a grid whose sides have a and b quads, by turns.
std::size_t startOfGrid(const std::vector<PlanarPoint>& corners, std::size_t a, std::size_t b) {
    std::vector<double> turns; // at the points of the rim; those between two corners do not turn
    for (const double each : turnsOf(corners))
        turns.insert(turns.end(), {each, 0.0});
    constexpr double tie = 1e-9;
    std::size_t best = 0;
    double largest = -1;
    for (std::size_t start = 0; start < a + b; ++start) {
        double sum = 0;
        for (const std::size_t side : {std::size_t{0}, a, a + b, 2 * a + b})
            sum += turns[(start + side) % turns.size()];
        if (sum <= largest + tie) continue;
        largest = sum;
        best = start;
    }
    return best;
}

} // namespace

bool needsGrid(const std::vector<PlanarPoint>& corners) {
    return corners.size() >= minCorners && corners.size() <= maxCorners && isConvex(corners) &&
           std::ranges::min(turnsOf(corners)) < maxTurn;
}

GridFilling gridFilling(const std::vector<PlanarPoint>& corners) {
    const std::size_t rim = 2 * corners.size();
    const std::size_t a = corners.size() / 2, b = corners.size() - a;
    const std::size_t start = startOfGrid(corners, a, b);
    GridFilling filling;
    filling.innerPoints = rim + (a - 1) * (b - 1); // the ring's inner side, and what is inside of the grid
    const auto ring = [&](std::size_t k) { return k < rim ? rim + k : k; };
    for (std::size_t k = 0; k < rim; ++k)
        filling.quads.push_back({k, (k + 1) % rim, ring(k + 1), ring(k)});
    const auto point = [&](std::size_t i, std::size_t j) {
        if (j == 0) return ring(start + i);
        if (i == a) return ring(start + a + j);
        if (j == b) return ring(start + a + b + (a - i));
        if (i == 0) return ring(start + 2 * a + b + (b - j));
        return 2 * rim + (j - 1) * (a - 1) + (i - 1);
    };
    for (std::size_t j = 0; j < b; ++j)
        for (std::size_t i = 0; i < a; ++i)
            filling.quads.push_back({point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)});
    return filling;
}

std::vector<Point> innerPoints(const GridFilling& filling, const std::vector<Point>& rim) {
    std::vector<std::pair<std::size_t, std::size_t>> edges; // in both directions
    for (const auto& quad : filling.quads)
        for (std::size_t k = 0; k < 4; ++k) {
            edges.emplace_back(quad[k], quad[(k + 1) % 4]);
            edges.emplace_back(quad[(k + 1) % 4], quad[k]);
        }
    sortUnique(edges);
    const auto count = static_cast<Eigen::Index>(filling.innerPoints);
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::MatrixXd right = Eigen::MatrixXd::Zero(count, 3);
    for (const auto& [from, to] : edges) {
        if (from < rim.size()) continue;
        const auto row = static_cast<Eigen::Index>(from - rim.size());
        entries.emplace_back(row, row, 1);
        if (to >= rim.size())
            entries.emplace_back(row, static_cast<Eigen::Index>(to - rim.size()), -1);
        else
            for (Eigen::Index k = 0; k < 3; ++k)
                right(row, k) += rim[to][static_cast<unsigned>(k)];
    }
    Eigen::SparseMatrix<double> matrix(count, count);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::MatrixXd places = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(matrix).solve(right);
    std::vector<Point> points;
    points.reserve(filling.innerPoints);
    for (Eigen::Index row = 0; row < count; ++row)
        points.emplace_back(places(row, 0), places(row, 1), places(row, 2));
    return points;
}

} // namespace qm
