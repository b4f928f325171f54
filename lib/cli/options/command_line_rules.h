/// \file Checks of a parsed command line against the declarations of a tool.
#pragma once

#include "cli/options/command_line.h"
#include "cli/options/usage.h"

#include <functional>
#include <set>
#include <string>
#include <vector>

namespace qm {

/// Options that have an effect only under a condition.
struct OptionCondition {
    std::vector<std::string> names;
    std::string what; ///< completes the sentence "has no effect without"
    std::function<bool()> holds;
};

/// Assigns words to the operands' variables, in order.
/// \param declared  the operands
/// \param targets   the variable of each operand; unchanged if there is no word for it
/// \param more      receives the remaining words; null if none are allowed
/// \throw UsageError  if there are too many words, or one is empty or required but missing
void assignOperands(const std::vector<std::string>& words, const std::vector<Operand>& declared,
                    const std::vector<std::string*>& targets, std::vector<std::string>* more);

/// \param given  names of the options on the command line
/// \throw UsageError  if one of them has no effect
void requireEffects(const std::vector<OptionCondition>& conditions, const std::set<std::string>& given);

} // namespace qm
