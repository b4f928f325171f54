/// \file The lines that people read on standard error.
#pragma once

#include <string>

namespace qm {

/// Writes one line to standard error at once. Control characters, which may come from file names and from
/// damaged input, are shown as question marks; very long lines are shortened.
void printMessage(const std::string& message);

/// Makes sure that no file that is opened later takes the number of a standard stream that is closed: the
/// tool's output would go into it.
void openStandardStreams();

} // namespace qm
