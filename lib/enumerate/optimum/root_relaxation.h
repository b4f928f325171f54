/// \file The relaxation at the root of a search tree, kept so that every better graph can fix more columns
/// there (docs/METHOD.md#optimum).
#pragma once

#include "base/infinity.h"
#include "enumerate/optimum/part_search.h"

#include <optional>
#include <utility>
#include <vector>

namespace qm {

/// The root of the search tree of one part: its state, and its last relaxed solution.
class RootRelaxation {
public:
    explicit RootRelaxation(PartSearch& part) : part_(part), state_(part.columns.mark()) {}

    /// Solves the root's relaxation approximately by gradients. `presence` is then known.
    /// \return a lower bound
    [[nodiscard]] double relaxNearly();
    /// Starts the simplex method from the solution found by gradients; it would take too long otherwise.
    void startFromNear() { part_.relaxation.startNear(*near_); }

    /// Whether a solution has been remembered.
    [[nodiscard]] bool isKnown() const { return !values_.empty(); }
    /// Stores the current state as the root's state, and the relaxation's last solution as the root's
    /// solution.
    void remember(double bound);
    /// The relaxed value of each of the part's variables, from the solution remembered last or else from
    /// gradients; empty if there is neither.
    [[nodiscard]] const std::vector<double>& presence() const { return presence_; }
    /// Hands over the solution found by gradients, which can be taken once; nothing if gradients were not
    /// used.
    [[nodiscard]] std::optional<RelaxedProgram> takeNear() { return std::exchange(near_, std::nullopt); }
    /// Returns to the root's state.
    void restore() { part_.columns.undo(state_); }
    /// Fixes more columns at the root, for good, if a better graph is known.
    /// \return false if no cheaper graph is left
    bool tighten();
    /// Solves the tightened root again, if that takes few iterations.
    [[nodiscard]] Relaxation::Result solveAgain();

private:
    void rememberPresence();

    PartSearch& part_;
    ColumnState::Mark state_;
    double bound_ = 0; ///< of the remembered solution
    ColumnValues values_;
    ColumnValues reducedCosts_;
    Relaxation::Basis basis_;
    std::vector<double> presence_;
    std::optional<RelaxedProgram> near_; ///< the solution found by gradients
    double cutoff_ = infinity;           ///< at the last tightening
};

} // namespace qm
