/// \file Turning layouts into solutions of the pruning program, and back (docs/METHOD.md#pruning-program).
#pragma once

#include "prune/grid_program.h"

#include <vector>

namespace qm {

/// The values of all columns for a layout.
/// \param layout  of the same mesh; the line that a component without arcs was given is ignored if it
/// lies on no arc
/// \throw Error  if other tracks are not made of whole arcs, see `presentArcs`
[[nodiscard]] ColumnValues valuesOf(const PrunedMesh& pruned, const GridProgram& grids, const Layout& layout);

/// The values with the same arcs, and indicators that follow from the arcs. A solver may leave an indicator
/// without cost at any value that the rows allow.
[[nodiscard]] ColumnValues completed(const GridProgram& grids, const ColumnValues& solved);

/// The layout whose tracks are the runs of arcs that are in, line by line.
[[nodiscard]] Layout layoutOf(const PrunedMesh& pruned, const GridProgram& grids, const ColumnValues& values);

/// For every line, the columns of its arcs in their order.
[[nodiscard]] std::vector<std::vector<ColumnId>> columnsOfLines(const ArcGraph& graph);

} // namespace qm
