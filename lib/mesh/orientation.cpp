#include "base/positions.h"
#include "mesh/soup_repairs.h"

namespace qm {
namespace {

enum class Turn : signed char { unknown, kept, reversed };

/// Orients each component by breadth-first search from one quad, marking the quads that disagree with it.
class Spreading {
public:
    Spreading(const Soup& soup, const std::vector<Side>& twins)
        : soup_(soup), twins_(twins), turns_(soup.faceCount(), Turn::unknown) {}

    Orientation run() {
        Orientation result;
        result.reversed.assign(soup_.faceCount(), false);
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
            for (Side side = static_cast<Side>(4 * face); side < 4 * (face + 1); ++side) {
                const Side twin = twins_[side];
                if (twin == twins_.size()) continue;
                const bool agree = sideFrom(soup_, side) != sideFrom(soup_, twin);
                const Turn wanted = agree == (turns_[face] == Turn::kept) ? Turn::kept : Turn::reversed;
                Turn& turn = turns_[twin / 4];
                if (turn == Turn::unknown) {
                    turn = wanted;
                    component_.push_back(twin / 4);
                } else if (turn != wanted) {
                    return twin / 4;
                }
            }
        }
        return std::nullopt;
    }

    const Soup& soup_;
    const std::vector<Side>& twins_;
    std::vector<Turn> turns_;
    std::vector<std::size_t> component_;
};

} // namespace

Orientation findOrientation(const Soup& soup, const std::vector<Side>& twins) {
    return Spreading(soup, twins).run();
}

} // namespace qm
