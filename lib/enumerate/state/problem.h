/// \file The search problem: binary variables for arcs under the arc rules (docs/METHOD.md#search-problem).
///
/// A whole mesh, a sub-mesh with its cut, and a window in an otherwise fixed layout all become such a
/// problem.
#pragma once

#include "base/id_vector.h"
#include "basecomplex/arc_graph.h"
#include "enumerate/state/arc_states.h"
#include "layout/walkers.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace qm {

using VariableId = Id<struct VariableTag>;
using ChainId = Id<struct ChainTag>;
using CrossingId = Id<struct CrossingTag>;
using CrackNodeId = Id<struct CrackNodeTag>;

/// Consecutive variables: the stretch of one line that holds all its free arcs (rule 3).
struct Chain {
    VariableId first;
    int count = 0;
    bool coveredBefore = false; ///< a particle comes in over the first variable, or starts there
    bool coveredAfter = false;  ///< likewise over the last variable, from the other end

    [[nodiscard]] IdRange<VariableId> variables() const { return {first, first + count}; }
    [[nodiscard]] bool has(VariableId id) const { return first <= id && id < first + count; }
};

/// A line, or several joined by fixed crossings, that can be cracked `capacity` times when covered from end
/// to end (rule 4).
struct CrackNode {
    ChainId chain; ///< that must be covered throughout; none where the lines are covered anyway
    int capacity = 1;
};

/// One of the two lines at a crossing: variables before and after it, and the node that a head-on meeting
/// here would use; none where no such meeting is possible.
struct CrossingSide {
    VariableId before;
    VariableId after;
    CrackNodeId node;
    bool seeded = false; ///< a feature seed: particles begin here, both ways, and none passes
};

/// How many corners segments have at a crossing, by the number of arcs of each line that are in.
constexpr int cornersAt(int arcsOfOne, int arcsOfOther) {
    return arcsOfOne * arcsOfOther;
}

/// An ordinary junction between variables and constants (rules 2 and 4).
struct Crossing {
    std::array<CrossingSide, 2> sides;
    bool open = false; ///< past a cut, where tracks may end unfinished: only rule 4 holds
    /// Of each corner that a segment has here, between an arc of one line and one of the other.
    double cornerCost = 0;

    /// The variables before and after the crossing on one line, then those on the other line.
    [[nodiscard]] std::array<VariableId, 4> arcs() const {
        return {sides[0].before, sides[0].after, sides[1].before, sides[1].after};
    }
    /// How many corners segments have here.
    /// \param isIn  whether a variable or constant is in
    template <class IsIn> [[nodiscard]] int corners(const IsIn& isIn) const {
        const auto arcsIn = [&](const CrossingSide& side) {
            return (isIn(side.before) ? 1 : 0) + (isIn(side.after) ? 1 : 0);
        };
        return cornersAt(arcsIn(sides[0]), arcsIn(sides[1]));
    }
};

/// The ids of variables, and after them those of two constants: in() is present, out() is absent.
struct Problem {
    IdVector<VariableId, ArcRun> arcs;      ///< of every variable, which can only be in or out together
    IdVector<VariableId, double> costs;     ///< of every variable when it is in; 0 for the two constants
    IdVector<VariableId, ArcState> domains; ///< of every variable and the two constants
    IdVector<ChainId, Chain> chains;
    IdVector<CrossingId, Crossing> crossings;
    IdVector<CrackNodeId, CrackNode> nodes;
    bool gaps = true; ///< rules 3 and 4 hold; without them the class is that of T-meshes

    [[nodiscard]] IdRange<VariableId> variables() const { return arcs.ids(); }
    [[nodiscard]] VariableId in() const { return arcs.nextId(); }
    [[nodiscard]] VariableId out() const { return in() + 1; }
    [[nodiscard]] bool isConstant(VariableId id) const { return id >= in(); }
};

/// What surrounds a search.
struct ProblemInput {
    const ArcGraph& graph;
    const IdVector<ArcId, double>& arcCosts;
    ArcStates states; ///< the free arcs become variables
    /// Of every arc: `in` or `out` where a person demands it, else `free`; may be empty.
    std::span<const ArcState> demands;
    OpenJunctions open;    ///< where tracks may end unfinished
    Walkers walkers;       ///< which particles take part
    double cornerCost = 0; ///< of every segment's corner at a junction that is not open
    /// Those with free arcs, ascending; if they are not given, all lines are looked at.
    std::optional<std::vector<LineId>> lines = {};
};

/// Linear in the graph, or where `lines` are given, in these, the lines across them, and those fixed lines
/// that are joined with one of them by crossings.
/// \throw Error  if the demands contradict rule 1 or fixed arcs
[[nodiscard]] Problem makeProblem(const ProblemInput& input);

} // namespace qm
