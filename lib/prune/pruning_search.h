/// \file The search for solutions of the pruning program, by greedy removal, CBC and neighbourhoods
/// (docs/METHOD.md#pruning-program).
#pragma once

#include "base/control.h"
#include "base/deadline.h"
#include "base/infinity.h"
#include "prune/grid_program.h"
#include "prune/prune.h"

#include <optional>
#include <vector>

namespace qm {

/// What a search minimises: G_T + beta * segments, with at most `maxSegments` segments.
struct PruningAim {
    double beta = 0; ///< price of a segment
    double maxSegments = infinity;
};

/// Searches for one aim after another. Every search begins with the solutions found by earlier ones.
class PruningSearch {
public:
    /// All references must outlive the object.
    /// \param layout   the starting point; results are never worse
    /// \param options  only the smoothness criterion and the constraints are used
    /// \throw Error  if the layout's tracks are not made of whole arcs
    PruningSearch(const PrunedMesh& pruned, const Layout& layout, const PruneOptions& options,
                  const Control& control);

    struct Found {
        ColumnValues values;
        double lowerBound = 0; ///< of what was minimised
        bool proven = false;   ///< no lower value exists
    };

    /// \throw Error  if no layout with so few segments was found
    [[nodiscard]] Found findCheapest(const PruningAim& aim, double seconds);

    /// Minimises the number of segments, whatever they cost; the bound is a bound of that number.
    [[nodiscard]] Found findFewest(double seconds);

    [[nodiscard]] double segments(const ColumnValues& values) const { return grids_.segments(values); }
    [[nodiscard]] Layout layoutOf(const ColumnValues& values) const;

private:
    void addPrice(IntegerProgram& program, double beta) const;
    [[nodiscard]] IntegerProgram programFor(const PruningAim& aim) const;
    [[nodiscard]] IntegerProgram::Row limitOn(double segments) const;
    void prepare(const IntegerProgram& program, double worth);
    void removeTracks(const Layout& layout, double worth);
    void approach(double maxSegments, const Deadline& end);
    void improveAt(double beta, double seconds);
    [[nodiscard]] ColumnValues improved(const IntegerProgram& program, ColumnValues values,
                                        double seconds) const;
    [[nodiscard]] std::optional<ColumnValues> bestKnown(const IntegerProgram& program,
                                                        double maxSegments) const;
    Found solve(const IntegerProgram& program, double maxSegments, const Deadline& end);

    PrunedMesh pruned_;
    const Layout& layout_;
    const PruneOptions& options_;
    const Control& control_;
    GridProgram grids_;
    std::vector<ColumnValues> known_; ///< all solutions found so far, whatever their cost
};

} // namespace qm
