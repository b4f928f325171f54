/// \file The linear relaxation of a search problem: its bound prunes, its solution guides (method 2).
///
/// A variable that two particles can reach is y = p + s: p the particle from before walks the arc, s the one
/// from after. Along a chain p falls and s rises; that is rule 3 and already integral. Rule 2 is linear in y,
/// and of two crossing lines at most one is passed by a single particle (A2), which implies rule 4.
#pragma once

#include "enumerate/search_state.h"

#include <memory>
#include <optional>
#include <vector>

class ClpSimplex;

namespace qm {

/// What a branch of the search says of one variable: its value, or that the particle from before (after) does
/// or does not walk it. The latter settles where two particles meet when the values alone leave it open.
struct Decision {
    enum class About : signed char { value, fromBefore, fromAfter };
    int variable = -1;
    About about = About::value;
    ArcState state = ArcState::free;
};

class Relaxation {
public:
    /// \param variables  free in the state; everything that they have rules with is fixed or among them
    Relaxation(const SearchState& state, std::vector<int> variables);
    ~Relaxation();
    Relaxation(Relaxation&&) noexcept;
    Relaxation& operator=(Relaxation&&) noexcept;
    Relaxation(const Relaxation&) = delete;
    Relaxation& operator=(const Relaxation&) = delete;

    /// Least relaxed cost of the variables under the state's values and the decisions about particles.
    /// \return nothing if it is infeasible or at least `cutoff`
    std::optional<double> solve(const SearchState& state, const std::vector<Decision>& decisions,
                                double cutoff);

    /// The walk that the last solution leaves most undecided, with both outcomes open; none if all are
    /// integral.
    [[nodiscard]] std::optional<Decision> undecidedWalk() const;

    /// A variable's value in the last solution, 0 to 1.
    [[nodiscard]] double value(int variable) const;

    /// Variables that cannot take the value named in any solution cheaper than `cutoff`, by the reduced costs
    /// of the last solution: pairs of a variable and the only value left.
    [[nodiscard]] std::vector<std::pair<int, ArcState>> fixings(double bound, double cutoff) const;

    [[nodiscard]] const std::vector<int>& variables() const { return variables_; }

private:
    /// Columns of a variable; -1 where a particle cannot reach it.
    struct Columns {
        int fromBefore = -1;
        int fromAfter = -1;
        int cover = -1; ///< row p + s <= 1, where both exist
    };
    class Builder;
    /// What holds even if the solver fails.
    [[nodiscard]] double trivialBound(const SearchState& state) const;

    std::vector<int> variables_;
    std::vector<Columns> columns_; ///< of every variable of the problem
    std::unique_ptr<ClpSimplex> solver_;
};

} // namespace qm
