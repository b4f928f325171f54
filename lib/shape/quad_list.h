/// \file Points and quads as plain lists, and what shapes do with them.
#pragma once

#include "mesh/quad_mesh.h"

#include <array>
#include <vector>

namespace qm {

struct QuadList {
    std::vector<Point> points;
    std::vector<std::array<int, 4>> quads; ///< counter-clockwise seen from outside
};

/// Divides every quad into n x n. New points lie on the edges and in the quads, bilinearly.
/// \pre n > 0; neighbours share their vertices
[[nodiscard]] QuadList refined(const QuadList& coarse, int n);
/// The same with as many parts as the axis has that an edge mostly runs along.
[[nodiscard]] QuadList refined(const QuadList& coarse, const std::array<int, 3>& n);

/// Moves every point towards the middle of its neighbours and part of the way back, which rounds edges and
/// keeps the volume about the same (docs/METHOD.md#taubin-1995).
void soften(QuadList& list, int rounds);

/// A grid of `columns` x `rows` quads. Opposite sides may be one.
struct GridTopology {
    int columns = 1;
    int rows = 1;
    bool columnsClosed = false;
    bool rowsClosed = false;
    int shift = 0; ///< closing the rows, column i meets column i + shift; columns must be closed then

    /// The vertex at a crossing; both coordinates may lie beyond the grid where it is closed.
    [[nodiscard]] int vertex(int column, int row) const;
    /// All quads, row by row, turning left from columns to rows.
    [[nodiscard]] std::vector<std::array<int, 4>> quads() const;
    /// Crossings that differ; vertex k lies at column k % width and row k / width.
    [[nodiscard]] int width() const { return columnsClosed ? columns : columns + 1; }
    [[nodiscard]] int height() const { return rowsClosed ? rows : rows + 1; }
    /// The quads, with a point at every crossing.
    /// \param pointAt  of a column and a row
    template <class PointAt> [[nodiscard]] QuadList withPoints(const PointAt& pointAt) const {
        QuadList list{{}, quads()};
        for (int row = 0; row < height(); ++row)
            for (int column = 0; column < width(); ++column)
                list.points.push_back(pointAt(column, row));
        return list;
    }
};

} // namespace qm
