#include "enumerate/state/junction_rule.h"

namespace qm {
namespace {

/// What rule 2 concludes about the four arcs around a junction. Bit k of a mask stands for arc k, in the
/// order before and after on one line, before and after on the other.
struct JunctionConclusion {
    unsigned forcedIn = 0;
    unsigned forcedOut = 0;
    bool possible = false;
};

constexpr bool allowedPattern(unsigned pattern) {
    const bool a0 = pattern & 1, a1 = pattern & 2, b0 = pattern & 4, b1 = pattern & 8;
    return (a0 == a1 || (b0 && b1)) && (b0 == b1 || (a0 && a1));
}

/// Conclusions for all 81 combinations; the index has the state of arc k as its digit k in base 3: 0 out, 1
/// in, 2 free.
constexpr auto makeConclusions() {
    std::array<JunctionConclusion, 81> table{};
    for (unsigned index = 0; index < 81; ++index) {
        unsigned all = 15, any = 0;
        for (unsigned pattern = 0; pattern < 16; ++pattern) {
            bool fits = allowedPattern(pattern);
            for (unsigned k = 0, rest = index; k < 4; ++k, rest /= 3)
                fits = fits && (rest % 3 == 2 || rest % 3 == ((pattern >> k) & 1));
            if (!fits) continue;
            table[index].possible = true;
            all &= pattern;
            any |= pattern;
        }
        table[index].forcedIn = all;
        table[index].forcedOut = ~any & 15;
    }
    return table;
}
constexpr auto conclusions = makeConclusions();

} // namespace

bool concludeAround(const Crossing& crossing, PartialAssignment& assignment) {
    const std::array<VariableId, 4> arcs = crossing.arcs();
    unsigned index = 0;
    for (const std::size_t k : {3U, 2U, 1U, 0U}) {
        const ArcState state = assignment.value(arcs[k]);
        index = index * 3 + (state == ArcState::free ? 2U : static_cast<unsigned>(state));
    }
    const JunctionConclusion& conclusion = conclusions[index];
    if (!conclusion.possible) return false;
    for (unsigned k = 0; k < 4; ++k) {
        if ((conclusion.forcedIn >> k & 1) && !assignment.set(arcs[k], ArcState::in)) return false;
        if ((conclusion.forcedOut >> k & 1) && !assignment.set(arcs[k], ArcState::out)) return false;
    }
    return true;
}

} // namespace qm
