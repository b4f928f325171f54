#include "enumerate/relaxation/formulation.h"

#include "enumerate/relaxation/formulation_columns.h"

#include <algorithm>
#include <utility>

namespace qm {
namespace {

/// Adds the rows of rules 2 and 4 and the costs of corners at crossings.
class CrossingRows {
public:
    CrossingRows(const SearchState& state, FormulationColumns& columns)
        : state_(state), problem_(state.problem()), columns_(columns) {}

    void add(const Crossing& crossing) {
        if (columns_.isForeign(crossing)) return;
        if (!crossing.open)
            for (const std::size_t k : {0U, 1U})
                addStops(crossing.sides[k], crossing.sides[1 - k]);
        if (crossing.cornerCost != 0 && anyFree(crossing)) addCorners(crossing);
        if (!problem_.gaps) return;
        Expression passes;
        for (const CrossingSide& side : crossing.sides)
            passes.add(columns_.surePass(side), -1);
        columns_.addLowerLimit(passes, -1);
    }

private:
    bool anyFree(const Crossing& crossing) const {
        return std::ranges::any_of(crossing.arcs(), [this](VariableId arc) { return state_.isFree(arc); });
    }

    /// Adds the cost of corners at a crossing, except those between arcs that are in already.
    void addCorners(const Crossing& crossing) {
        Expression corners = problem_.gaps ? cornersByStops(crossing) : cornersByArcs(crossing);
        corners.constant -= crossing.corners([this](VariableId arc) { return columns_.isIn(arc); });
        columns_.addCost(corners, crossing.cornerCost);
    }

    /// The number of corners: two for every particle that stops.
    Expression cornersByStops(const Crossing& crossing) const {
        Expression corners;
        for (const CrossingSide& side : crossing.sides) {
            if (columns_.isWall(side)) continue;
            if (columns_.consecutive(side)) {
                for (const Expression& stop : columns_.particleStops(side))
                    corners.add(stop, 2);
                continue;
            }
            VariableId known = side.before, other = side.after; // one of the two is fixed
            if (columns_.columns(known).any()) std::swap(known, other);
            const int sign = columns_.isIn(known) ? 1 : -1;
            corners.add(columns_.present(known), 2 * sign).add(columns_.present(other), -2 * sign);
        }
        return corners;
    }

    /// The number of corners: two for every arc, less four if there is any arc. A new column is 1 if there is
    /// none.
    Expression cornersByArcs(const Crossing& crossing) {
        const ColumnId empty = columns_.newFlag();
        Expression corners{{{empty, 4}}, -4};
        for (const VariableId arc : crossing.arcs()) {
            corners.add(columns_.present(arc), 2);
            columns_.addLowerLimit(Expression{}.add(empty, -1).add(columns_.present(arc), -1), -1);
        }
        const auto& [a, b] = crossing.sides;
        for (const VariableId one : {a.before, a.after})
            for (const VariableId other : {b.before, b.after})
                columns_.addLowerLimit(
                    Expression{}.add(empty, 1).add(columns_.present(one), 1).add(columns_.present(other), 1),
                    1);
        return corners;
    }

    /// Rule 2: if a track ends on `side`, the line `wall` is passed or both its arcs are present.
    void addStops(const CrossingSide& side, const CrossingSide& wall) {
        std::array<Expression, 2> stops{columns_.present(side.before).add(columns_.present(side.after), -1),
                                        columns_.present(side.after).add(columns_.present(side.before), -1)};
        if (problem_.gaps && columns_.consecutive(side)) stops = columns_.particleStops(side);
        std::vector<Expression> walls;
        if (problem_.gaps && columns_.consecutive(wall))
            walls = {columns_.pass(wall)};
        else
            walls = {columns_.present(wall.before), columns_.present(wall.after)};
        for (const Expression& stop : stops)
            for (Expression row : walls)
                columns_.addLowerLimit(row.add(stop, -1), 0);
    }

    const SearchState& state_;
    const Problem& problem_;
    FormulationColumns& columns_;
};

} // namespace

Formulation formulate(const SearchState& state, const std::vector<VariableId>& variables) {
    FormulationColumns columns(state, variables);
    CrossingRows rows(state, columns);
    std::vector<CrossingId> plain;
    for (const CrossingId id : columns.crossings()) {
        const Crossing& crossing = state.problem().crossings[id];
        rows.add(crossing);
        if (columns.isPlain(crossing)) plain.push_back(id);
    }
    Formulation result = columns.take();
    result.plainCrossings = std::move(plain);
    return result;
}

} // namespace qm
