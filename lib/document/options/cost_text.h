/// \file A cost as text: "dihedral+0.5*segments".
#pragma once

#include "layout/cost.h"

#include <string>
#include <string_view>

namespace qm {

/// Terms with weight 0 are left out; "0" if all are.
[[nodiscard]] std::string costText(const CostTerms& terms);

/// Reads a sum of terms, each "name" or "number*name"; all other terms get weight 0.
/// \return what is wrong with the text; empty if nothing is
[[nodiscard]] std::string parseCost(std::string_view text, CostTerms& terms);

/// Calls f(name, weight) for every term.
template <class Terms, class Function> void forEachTerm(Terms& terms, const Function& f) {
    f("dihedral", terms.dihedral);
    f("length", terms.length);
    f("segments", terms.segments);
    f("custom", terms.custom);
}

} // namespace qm
