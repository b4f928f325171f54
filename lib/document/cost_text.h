/// \file A cost as people write it: "dihedral+0.5*segments".
#pragma once

#include "layout/cost.h"

#include <string>
#include <string_view>

namespace qm {

/// Terms with weight 0 are left out; "0" if all are.
[[nodiscard]] std::string costText(const CostTerms& terms);

/// A sum of terms, each a name or "number*name"; what is not named has weight 0.
/// \return what is wrong with the text, or empty
[[nodiscard]] std::string parseCost(std::string_view text, CostTerms& terms);

/// Calls f(name, weight) for every term.
template <class Terms, class Function> void forEachTerm(Terms& terms, const Function& f) {
    f("dihedral", terms.dihedral);
    f("length", terms.length);
    f("segments", terms.segments);
    f("custom", terms.custom);
}

} // namespace qm
