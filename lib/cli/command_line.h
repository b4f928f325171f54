/// \file A command line taken apart by CLI11: options to their records, the other words to the caller.
#pragma once

#include "cli/option_record.h"

#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace qm {

/// A wrong command line: one line on standard error that points to --help, and status 2.
class UsageError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

struct CommandLine {
    std::set<std::string> given;       ///< names of options
    std::vector<std::string> operands; ///< all words that are no options and no values
    /// The first thing that is wrong: a value that its option does not take, or an option that does not
    /// exist; empty if there is none. No exception, because --help is to work all the same.
    std::string problem;
};

/// Sets the variables of the options that are given; the last one counts of those that are given twice.
/// \throw UsageError  if the words cannot be told apart: a value is missing, say
[[nodiscard]] CommandLine readCommandLine(int argc, char** argv, const std::vector<OptionRecord>& options);

} // namespace qm
