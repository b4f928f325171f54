/// \file What the declarations of a tool demand of a command line that has been taken apart.
#pragma once

#include "cli/command_line.h"
#include "cli/usage.h"

#include <functional>
#include <set>
#include <string>
#include <vector>

namespace qm {

/// Options that have an effect only if something holds.
struct OptionCondition {
    std::vector<std::string> names;
    std::string what; ///< ends the sentence "has no effect without"
    std::function<bool()> holds;
};

/// Gives words to the variables of the operands, in their order.
/// \param declared  the operands
/// \param targets   the variable of each; it keeps its value if there is no word for it
/// \param more      takes the words that are left; null if there may be none
/// \throw UsageError  if there are too many words, one is empty, or a required one is missing
void assignOperands(const std::vector<std::string>& words, const std::vector<Operand>& declared,
                    const std::vector<std::string*>& targets, std::vector<std::string>* more);

/// \param given  names of the options on the command line
/// \throw UsageError  if one of them has no effect
void requireEffects(const std::vector<OptionCondition>& conditions, const std::set<std::string>& given);

} // namespace qm
