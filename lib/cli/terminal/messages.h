/// \file Printing messages for people on standard error.
#pragma once

#include <string>

namespace qm {

/// Writes one line to standard error at once. Control characters, which may come from file names or damaged
/// input, are shown as question marks; very long lines are shortened.
void printMessage(const std::string& message);

/// Opens closed standard streams, so that no file opened later takes the number of one, which would send the
/// tool's output into that file.
void openStandardStreams();

} // namespace qm
