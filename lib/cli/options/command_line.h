/// \file Parsing of command lines by CLI11: option values go to their records, all other words to the caller.
#pragma once

#include "cli/options/option_record.h"

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

} // namespace qm
