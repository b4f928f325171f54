#include "mesh/orientation.h"

#include "base/positions.h"

namespace qm {

Orientation findOrientation(std::size_t sides, const std::vector<Side>& twins,
                            const std::function<bool(Side, Side)>& agree) {
    enum class Turn : signed char { unknown, kept, reversed };
    std::vector<Turn> turns(twins.size() / sides, Turn::unknown);
    Orientation result;
    result.reversed.assign(turns.size(), false);
    std::vector<std::size_t> component; // those reached so far from its first face, by breadth-first search
    for (std::size_t start = 0; start < turns.size(); ++start) {
        if (turns[start] != Turn::unknown) continue;
        turns[start] = Turn::kept;
        component.assign(1, start);
        for (std::size_t k = 0; k < component.size(); ++k) {
            const std::size_t face = component[k];
            for (Side side = static_cast<Side>(sides * face); side < sides * (face + 1); ++side) {
                if (twins[side] == twins.size()) continue;
                const bool stays = agree(side, twins[side]) == (turns[face] == Turn::kept);
                const Turn wanted = stays ? Turn::kept : Turn::reversed;
                const std::size_t neighbour = twins[side] / sides;
                if (turns[neighbour] == Turn::unknown) {
                    turns[neighbour] = wanted;
                    component.push_back(neighbour);
                } else if (turns[neighbour] != wanted) {
                    result.contradiction = neighbour;
                    return result;
                }
            }
        }
        const auto turned =
            countWhere(component, [&](std::size_t face) { return turns[face] == Turn::reversed; });
        const Turn fewer = 2 * turned <= component.size() ? Turn::reversed : Turn::kept;
        for (const std::size_t face : component)
            result.reversed[face] = turns[face] == fewer;
    }
    return result;
}

} // namespace qm
