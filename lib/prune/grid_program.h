/// \file Which arcs of the base complex keep every segment a grid, as an integer program
/// (docs/METHOD.md#pruning-program).
///
/// One binary variable an arc. A segment takes at most two quads at any vertex, so that by Gauss-Bonnet it is
/// a grid with four corners, or an annulus or torus with none:
/// - at a junction where exactly one arc of a line is in, both arcs of the other are;
/// - at a seed that no line crosses both arcs are in, or both are out;
/// - of two neighbouring edges at an extraordinary vertex at least one is in.
/// Arcs with required edges are in, and those with forbidden ones are out. Further variables make the number
/// of segments linear: every corner counts a quarter, and every annulus, which becomes one segment when it is
/// split, counts like four corners.
#pragma once

#include "basecomplex/arc_graph.h"
#include "layout/constraints.h"
#include "layout/layout.h"
#include "program/integer_program.h"
#include "prune/pruned_mesh.h"

#include <utility>
#include <vector>

namespace qm {

/// What a removal may do to what stays, in degrees; anything, if nothing is said.
struct Smoothness {
    double maxTurn = 180; ///< where a border would turn by more, what supports it must stay
    double minCorner = 0; ///< that a corner keeps at an extraordinary vertex, see `roomAt`
};

/// The first columns are the arcs, and after them come the indicators.
struct GridProgram {
    [[nodiscard]] static ColumnId columnOf(ArcId arc) { return ColumnId(arc.value()); }

    /// A column that follows from the arcs.
    struct Indicator {
        enum class OneIf { anyIsIn, noneIsIn };
        std::vector<ArcId> arcs;
        OneIf when = OneIf::anyIsIn;
    };

    ArcGraph graph;           ///< of the base complex
    std::vector<ArcId> arcOf; ///< the arc on every edge; none for edges without a line
    IntegerProgram program;   ///< minimises G_T, with the lines that components without tracks get
    ColumnValues quarters;    ///< corners that every column adds
    double corners = 0;       ///< that are there anyway
    std::vector<Indicator> indicators;

    using Terms = std::vector<std::pair<ArcId, double>>; ///< arcs and their weights

    /// Adds a row: sum of the terms >= lower. Arcs that are invalid are out.
    void addRow(const Terms& terms, double lower);
    /// \param addedQuarters  corners that are there if the column is 1
    /// \return the new column
    ColumnId addIndicator(Indicator indicator, double addedQuarters, double cost = 0);

    /// How many segments there are: a quarter of their corners.
    [[nodiscard]] double segments(const ColumnValues& values) const;

    /// All columns.
    [[nodiscard]] ColumnValues valuesOf(const PresentArcs& present) const;
};

/// \param layout   what it has removed already may stay so, and where its tracks end is where a further
///                 removal could make a border turn
[[nodiscard]] GridProgram gridProgram(const PrunedMesh& pruned, const Layout& layout,
                                      const Smoothness& smoothness, const Constraints& constraints = {});

} // namespace qm
