/// \file How the allocator treats memory that is freed.
#pragma once

namespace qm {

/// Tells the C library to keep what is freed instead of handing it back to the system at once. Solvers take
/// and free the same arrays thousands of times a second, and each new page costs a fault: the searches take
/// half the time, the fits four fifths. What is above 256 megabytes is handed back all the same.
void keepFreedMemory();

} // namespace qm
