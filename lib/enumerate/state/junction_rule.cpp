#include "enumerate/state/junction_rule.h"

namespace qm {
namespace {

constexpr bool allowedPattern(unsigned pattern) {
    const bool a0 = pattern & 1, a1 = pattern & 2, b0 = pattern & 4, b1 = pattern & 8;
    return (a0 == a1 || (b0 && b1)) && (b0 == b1 || (a0 && a1));
}

/// Conclusions for all 81 combinations; the index has the state of arc k as its digit k in base 3.
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

const JunctionConclusion& concludeAtJunction(unsigned states) {
    return conclusions[states];
}

} // namespace qm
