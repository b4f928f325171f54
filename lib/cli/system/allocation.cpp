#include "cli/system/allocation.h"

#include <cstdlib>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace qm {

#ifdef __GLIBC__
namespace {
constexpr int megabyte = 1 << 20;
constexpr int keptMegabytes = 256;
constexpr int largestFromHeap = 32; ///< megabytes; the largest that the C library allows
} // namespace

void keepFreedMemory() {
    mallopt(M_TRIM_THRESHOLD, keptMegabytes * megabyte);
    mallopt(M_MMAP_THRESHOLD, largestFromHeap * megabyte);
}
#else
void keepFreedMemory() {}
#endif

} // namespace qm
