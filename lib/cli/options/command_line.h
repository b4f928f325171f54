/// \file Parsing of command lines by CLI11: option values go to their records, all other words to the caller.
/// Then they are checked against the declarations of a tool.
#pragma once

#include "cli/options/usage.h"

#include <functional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace qm {

/// A wrong command line, reported by one line on standard error that recommends --help, and by status 2.
class UsageError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

struct CommandLine {
    std::set<std::string> given;       ///< names of the options given
    std::vector<std::string> operands; ///< all words that are neither options nor values
    /// The first error: a value that its option does not allow, or an unknown option; empty if there is none.
    /// No exception, because --help must work all the same.
    std::string problem;
};

/// Sets the variables of the options given; if an option is given twice, the last value counts.
/// \throw UsageError  if the words cannot be parsed, for example if a value is missing
[[nodiscard]] CommandLine readCommandLine(int argc, char** argv, const std::vector<OptionRecord>& options);

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
