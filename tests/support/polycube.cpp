#include "support/polycube.h"

#include "base/at.h"

#include <cmath>
#include <cstring>
#include <map>
#include <numbers>
#include <numeric>
#include <set>

namespace qm::test {

namespace {

using Position = std::array<int, 3>;

/// Numbers lattice points in the order in which they are first used.
class Builder {
public:
    explicit Builder(double unit) : unit_(unit) {}

    void add(const std::array<Position, 4>& corners) {
        std::array<int, 4> quad{};
        for (std::size_t i = 0; i < 4; ++i) {
            const auto [known, isNew] = number_.emplace(corners[i], static_cast<int>(number_.size()));
            if (isNew)
                mesh_.points.push_back({corners[i][0] * unit_, corners[i][1] * unit_, corners[i][2] * unit_});
            quad[i] = known->second;
        }
        mesh_.quads.push_back(quad);
    }

    check::CheckedMesh mesh() { return std::move(mesh_); }

private:
    double unit_;
    check::CheckedMesh mesh_;
    std::map<Position, int> number_;
};

Position moved(Position position, std::size_t axis, int by) {
    position[axis] += by;
    return position;
}

} // namespace

check::CheckedMesh polycube(const Cells& cells, int n) {
    const std::set<Position> solid(cells.begin(), cells.end());
    Builder builder(1.0 / n);
    for (const Position& cell : solid) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            for (const int side : {0, 1}) {
                if (solid.contains(moved(cell, axis, side == 1 ? 1 : -1))) continue;
                // u, v and the outward normal form a right-handed system.
                const std::size_t u = (axis + (side == 1 ? 1 : 2)) % 3;
                const std::size_t v = (axis + (side == 1 ? 2 : 1)) % 3;
                for (int i = 0; i < n; ++i) {
                    for (int j = 0; j < n; ++j) {
                        Position low{cell[0] * n, cell[1] * n, cell[2] * n};
                        low[axis] += side * n;
                        low[u] += i;
                        low[v] += j;
                        builder.add({low, moved(low, u, 1), moved(moved(low, u, 1), v, 1), moved(low, v, 1)});
                    }
                }
            }
        }
    }
    return builder.mesh();
}

Cells box(int x, int y, int z) {
    Cells cells;
    for (int i = 0; i < x; ++i)
        for (int j = 0; j < y; ++j)
            for (int k = 0; k < z; ++k)
                cells.push_back({i, j, k});
    return cells;
}

Cells bump() {
    Cells cells = box(3, 3, 1);
    cells.push_back({1, 1, 1});
    return cells;
}

check::CheckedMesh plane(const std::vector<const char*>& rows) {
    Builder builder(1);
    for (int y = 0; y < static_cast<int>(rows.size()); ++y)
        for (int x = 0; x < static_cast<int>(std::strlen(rows[at(y)])); ++x)
            if (rows[at(y)][x] == 'x')
                builder.add({Position{x, y, 0}, {x + 1, y, 0}, {x + 1, y + 1, 0}, {x, y + 1, 0}});
    return builder.mesh();
}

check::CheckedMesh torus(int a, int b) {
    check::CheckedMesh mesh;
    for (int j = 0; j < b; ++j)
        for (int i = 0; i < a; ++i) {
            const double u = 2 * std::numbers::pi * i / a;
            const double v = 2 * std::numbers::pi * j / b;
            mesh.points.push_back(
                {(3 + std::cos(v)) * std::cos(u), (3 + std::cos(v)) * std::sin(u), std::sin(v)});
            const auto number = [&](int column, int row) { return row % b * a + column % a; };
            mesh.quads.push_back({number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)});
        }
    return mesh;
}

check::CheckedMesh tube(int a, int b) {
    check::CheckedMesh mesh;
    for (int j = 0; j <= b; ++j)
        for (int i = 0; i < a; ++i) {
            const double u = 2 * std::numbers::pi * i / a;
            mesh.points.push_back({std::cos(u), std::sin(u), static_cast<double>(j)});
            const auto number = [&](int column, int row) { return row * a + column % a; };
            if (j < b)
                mesh.quads.push_back(
                    {number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)});
        }
    return mesh;
}

check::CheckedMesh glued(int squares, const std::vector<std::array<int, 2>>& pairs, int n) {
    // The number of lattice point (i, j) of a square, and of the k-th point on side s, counter-clockwise.
    const auto point = [&](int square, int i, int j) { return (square * (n + 1) + j) * (n + 1) + i; };
    const auto onSide = [&](int side, int k) {
        const std::array<std::array<int, 2>, 4> places{{{k, 0}, {n, k}, {n - k, n}, {0, n - k}}};
        const auto [i, j] = places[at(side % 4)];
        return point(side / 4, i, j);
    };
    std::vector<int> same(static_cast<std::size_t>(squares * (n + 1) * (n + 1)));
    std::iota(same.begin(), same.end(), 0);
    const auto root = [&](int p) {
        while (same[at(p)] != p)
            p = same[at(p)];
        return p;
    };
    for (const auto& [one, other] : pairs)
        for (int k = 0; k <= n; ++k)
            same[at(root(onSide(one, k)))] = root(onSide(other, n - k));

    check::CheckedMesh mesh;
    std::map<int, int> number;
    const auto vertex = [&](int p) {
        const auto [known, isNew] = number.emplace(root(p), static_cast<int>(number.size()));
        if (isNew)
            mesh.points.push_back(
                {std::sin(known->first), std::sin(2.5 * known->first), std::sin(4.1 * known->first)});
        return known->second;
    };
    for (int square = 0; square < squares; ++square)
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i)
                mesh.quads.push_back({vertex(point(square, i, j)), vertex(point(square, i + 1, j)),
                                      vertex(point(square, i + 1, j + 1)), vertex(point(square, i, j + 1))});
    return mesh;
}

check::CheckedMesh together(const std::vector<check::CheckedMesh>& parts) {
    check::CheckedMesh result;
    for (const check::CheckedMesh& part : parts) {
        const int base = static_cast<int>(result.points.size());
        result.points.insert(result.points.end(), part.points.begin(), part.points.end());
        for (auto quad : part.quads) {
            for (int& corner : quad)
                corner += base;
            result.quads.push_back(quad);
        }
    }
    return result;
}

} // namespace qm::test
