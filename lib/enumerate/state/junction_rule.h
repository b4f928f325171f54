/// \file Rule 2 (docs/METHOD.md#arc-rules): which arcs may meet at an ordinary junction.
#pragma once

#include "enumerate/state/problem.h"

namespace qm {

/// What rule 2 concludes about the four arcs around a junction. Bit k of a mask stands for arc k, in the
/// order before and after on one line, before and after on the other.
struct JunctionConclusion {
    unsigned forcedIn = 0;
    unsigned forcedOut = 0;
    bool possible = false;
};

/// \param states  of the four arcs as digits in base 3, the first arc the lowest digit: 0 out, 1 in, 2 free
[[nodiscard]] const JunctionConclusion& concludeAtJunction(unsigned states);

} // namespace qm
