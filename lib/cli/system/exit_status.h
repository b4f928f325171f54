/// \file The exit status of a tool, and one line on standard error for any error.
#pragma once

#include <functional>
#include <string>

namespace qm {

enum ExitStatus : int {
    exitDone = 0,
    exitFailure = 1, ///< bad input or any other error
    exitUsage = 2,   ///< bad command line
    /// The output is written, but misses a requirement (a tolerance, --require-complete, --require-optimal),
    /// or the run was interrupted.
    exitUnmet = 3
};

/// Runs `work` and returns its status; if it throws, `exitUsage` for a UsageError, otherwise `exitFailure`.
/// \param tool   the name for which --help is recommended
/// \param input  name of the input, which any Error is about; empty if there is none
/// \param say    called once with the message if an exception is thrown
[[nodiscard]] int statusOf(const std::function<int()>& work, const std::string& tool,
                           const std::function<std::string()>& input,
                           const std::function<void(const std::string& message)>& say);

} // namespace qm
