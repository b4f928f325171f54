/// \file Signals and other sudden ends: no half-written file is left behind, and a long search may end with
/// its best so far.
#pragma once

#include <string>

namespace qm {

/// From now on signals that end the process remove its temporary files first. Signals that the parent process
/// ignores stay ignored. Writing beyond the limit on the size of files fails like any other write.
void watchSignals();

/// From now on the end of memory is told in one line where no exception can tell it.
void watchMemory(const std::string& tool);

/// The next interrupt only makes `wasInterrupted` true, and so do others within a second of it; one more ends
/// the process.
void deferInterrupt();
[[nodiscard]] bool wasInterrupted();

/// A file to be removed by a signal. Throws Error if there are too many.
void registerTemporaryFile(const std::string& path);
void forgetTemporaryFile(const std::string& path);

} // namespace qm
