/// \file Surfaces and their reference as polynomials over common cells, and the steps from patch to patch.
#pragma once

#include "bspline/network/borders.h"
#include "bspline/reference/lattice/reference_grid.h"
#include "bspline/splines/patch_bezier.h"
#include "bspline/splines/surfaces.h"
#include "layout/layout.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace qm {

/// A cell: an interval of u and one of v in which both surfaces are polynomials.
struct Cell {
    std::size_t patch = 0;
    std::array<std::size_t, 2> interval{};

    friend bool operator==(const Cell&, const Cell&) = default;
};

/// The fitted surfaces, number 0, and their reference, number 1, over the same patches.
class PairedSurfaces {
public:
    /// The arguments must outlive it.
    /// \param references  by patch
    /// \param borders     of the layout
    PairedSurfaces(const Layout& layout, const std::vector<Patch>& patches,
                   const std::vector<ReferenceGrid>& references, const std::vector<BorderEdge>& borders,
                   unsigned jobs);

    [[nodiscard]] std::size_t patches() const { return pieces_[0].size(); }
    /// The largest u and v of a patch; the smallest are 0.
    [[nodiscard]] Parameters extent(std::size_t patch) const;
    /// All cells of a patch, row by row.
    [[nodiscard]] std::vector<Cell> cells(std::size_t patch) const;
    [[nodiscard]] ParameterBox box(const Cell& cell) const;
    [[nodiscard]] Cell cellAt(const LayoutPlace& place) const;

    /// The polynomial over a cell; all have the same degree in both directions.
    /// \param piece  is overwritten
    void get(std::size_t surface, const Cell& cell, BezierPiece& piece) const;

    /// A step across a border into the next patch.
    struct Crossing {
        LayoutPlace to;
        int turns = 0; ///< counter-clockwise quarters from a direction in the old patch to that in the new
        bool isGapless = false; ///< the fitted patches meet there, over a whole mesh edge
    };
    /// The step from a place on a side of its patch; none on the mesh boundary.
    [[nodiscard]] std::optional<Crossing> across(const LayoutPlace& place, int side) const;

private:
    const Layout& layout_;
    std::array<std::vector<BezierPieces>, 2> pieces_;
    /// What lies beyond an edge of a side.
    struct Beyond {
        std::optional<BorderPlace> place; ///< none on the mesh boundary
        bool isGapless = false;
    };
    std::vector<std::array<std::vector<Beyond>, 4>> beyond_; ///< by patch, side and position
};

/// The polynomial over the cell that was asked for last: searches often stay in one.
class LastPiece {
public:
    explicit LastPiece(const PairedSurfaces& surfaces) : surfaces_(surfaces) {}

    const BezierPiece& operator()(std::size_t surface, const Cell& cell);

private:
    const PairedSurfaces& surfaces_;
    std::optional<std::size_t> surface_;
    Cell cell_;
    BezierPiece piece_;
};

} // namespace qm
