#include "mesh/orientation.h"

#include "base/positions.h"

namespace qm {
namespace {

enum class Turn : signed char { unknown, kept, reversed };

/// Orients each component by breadth-first search from one quad, marking the quads that disagree with it.
class Spreading {
public:
    Spreading(std::size_t sides, const std::vector<Side>& twins, const std::function<bool(Side, Side)>& agree)
        : sides_(sides), twins_(twins), agree_(agree), turns_(twins.size() / sides, Turn::unknown) {}

    Orientation run() {
        Orientation result;
        result.reversed.assign(turns_.size(), false);
        for (std::size_t start = 0; start < turns_.size(); ++start) {
            if (turns_[start] != Turn::unknown) continue;
            if (result.contradiction = spread(start); result.contradiction) return result;
            const auto turned =
                countWhere(component_, [&](std::size_t face) { return turns_[face] == Turn::reversed; });
            const Turn fewer = 2 * turned <= component_.size() ? Turn::reversed : Turn::kept;
            for (const std::size_t face : component_)
                result.reversed[face] = turns_[face] == fewer;
        }
        return result;
    }

private:
    std::optional<std::size_t> spread(std::size_t start) {
        component_.assign(1, start);
        turns_[start] = Turn::kept;
        for (std::size_t k = 0; k < component_.size(); ++k) {
            const std::size_t face = component_[k];
            for (Side side = static_cast<Side>(sides_ * face); side < sides_ * (face + 1); ++side) {
                const Side twin = twins_[side];
                if (twin == twins_.size()) continue;
                const bool stays = agree_(side, twin) == (turns_[face] == Turn::kept);
                const Turn wanted = stays ? Turn::kept : Turn::reversed;
                Turn& turn = turns_[twin / sides_];
                if (turn == Turn::unknown) {
                    turn = wanted;
                    component_.push_back(twin / sides_);
                } else if (turn != wanted) {
                    return twin / sides_;
                }
            }
        }
        return std::nullopt;
    }

    std::size_t sides_;
    const std::vector<Side>& twins_;
    const std::function<bool(Side, Side)>& agree_;
    std::vector<Turn> turns_;
    std::vector<std::size_t> component_;
};

} // namespace

Orientation findOrientation(std::size_t sides, const std::vector<Side>& twins,
                            const std::function<bool(Side, Side)>& agree) {
    return Spreading(sides, twins, agree).run();
}

} // namespace qm
