/// \file What the relaxation says of the root of a search tree, kept to fix more there with every better
/// graph (docs/METHOD.md#optimum).
#pragma once

#include "enumerate/optimum/part_search.h"

#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace qm {

/// The root of the search of one part: its state, and the last relaxed solution there.
class RootRelaxation {
public:
    explicit RootRelaxation(PartSearch& part) : part_(part), state_(part.columns.mark()) {}

    /// Solves the root's relaxation nearly, by gradients, and lets the simplex method begin there: from afar
    /// it would take too long.
    /// \return a bound
    [[nodiscard]] double startByGradients();

    /// Whether a solution was remembered.
    [[nodiscard]] bool isKnown() const { return !values_.empty(); }
    /// Takes the state for the root's, and the solution that the relaxation has just found for that of the
    /// root.
    void remember(double bound);
    /// The value of each of the part's variables, in the last solution that was remembered or found by
    /// gradients; empty if there was none.
    [[nodiscard]] const std::vector<double>& presence() const { return presence_; }
    /// What gradients found, once; nothing if they were not asked.
    [[nodiscard]] std::optional<RelaxedProgram> takeNear() { return std::exchange(near_, std::nullopt); }
    /// Brings the root's state back.
    void restore() { part_.columns.undo(state_); }
    /// A better graph lets more be fixed at the root, for good.
    /// \return false if nothing cheaper is left
    bool tighten();
    /// Solves the tightened root again, in few iterations or not at all.
    [[nodiscard]] Relaxation::Result solveAgain();

private:
    void rememberPresence();

    PartSearch& part_;
    ColumnState::Mark state_;
    double bound_ = 0; ///< with values and reduced costs
    ColumnValues values_;
    ColumnValues reducedCosts_;
    Relaxation::Basis basis_;
    std::vector<double> presence_;
    std::optional<RelaxedProgram> near_;                      ///< what gradients say of the root
    double cutoff_ = std::numeric_limits<double>::infinity(); ///< at the last tightening
};

} // namespace qm
