/// \file Which arcs of the base complex keep every segment a grid, as an integer program
/// (docs/METHOD.md#pruning-program).
///
/// One binary variable an arc, and one a junction that says whether any track runs over it. A segment takes
/// at most two quads at any vertex, so that by Gauss-Bonnet it is a grid with four corners or an annulus:
/// - at a junction where exactly one arc of a line is in, both arcs of the other are;
/// - of two neighbouring edges at an extraordinary vertex at least one is in.
/// The number of segments is linear: every corner of one counts a quarter.
#pragma once

#include "basecomplex/arc_graph.h"
#include "layout/layout.h"
#include "program/integer_program.h"

#include <vector>

namespace qm {

/// Columns 0 .. arcs - 1 are the arcs, and after them come the junctions.
struct GridProgram {
    IntegerProgram program;       ///< minimises G_T
    std::vector<double> quarters; ///< corners that every column adds
    double corners = 0;           ///< that every layout has

    /// Corners / 4; annuli are not counted.
    [[nodiscard]] double segments(const std::vector<double>& values) const;
};

/// \param layout   the start; where its tracks end, a removal could make a border turn
/// \param maxTurn  degrees: where a border turns by more, the track that ends there must stay
[[nodiscard]] GridProgram gridProgram(const QuadMesh& mesh, const BaseComplex& complex, const ArcGraph& graph,
                                      const std::vector<double>& arcCosts, const Layout& layout,
                                      double maxTurn);

} // namespace qm
