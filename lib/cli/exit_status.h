/// \file How a tool ends: its status, and one line on standard error for whatever went wrong.
#pragma once

#include <functional>
#include <string>

namespace qm {

enum ExitStatus : int {
    exitDone = 0,
    exitFailure = 1, ///< bad input, or anything that went wrong
    exitUsage = 2,   ///< bad command line
    /// Written, but not what was asked for: a tolerance, --require-complete, --require-optimal; or
    /// interrupted.
    exitUnmet = 3
};

/// The status that `work` returns, or that of what it throws: `exitUsage` for a UsageError, else
/// `exitFailure`.
/// \param tool   named where its --help is recommended
/// \param input  the input's name, which an Error is about; empty if there is none
/// \param say    called once with the message if something is thrown
[[nodiscard]] int statusOf(const std::function<int()>& work, const std::string& tool,
                           const std::function<std::string()>& input,
                           const std::function<void(const std::string& message)>& say);

} // namespace qm
