/// \file Lays the tools' large blocks of memory on huge pages, where the system grants them on request: page
/// by page, setting up the memory of a large mesh takes up to a third of the time of quick tools. Small
/// blocks, and all blocks of programs that use the library, are allocated as everywhere.
#include <cstddef>
#include <cstdlib>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace {

constexpr std::size_t hugePage = std::size_t{2} << 20;
/// Smaller blocks hardly ever contain a whole huge page.
constexpr std::size_t large = 2 * hugePage;

void* allocated(std::size_t size) {
#ifdef MADV_HUGEPAGE
    if (void* block = nullptr; size >= large && posix_memalign(&block, hugePage, size) == 0) {
        madvise(block, size, MADV_HUGEPAGE); // a wish: without it, pages are small
        return block;
    }
#endif
    return std::malloc(size > 0 ? size : 1);
}

} // namespace

// The other forms of both operators call these.

void* operator new(std::size_t size) {
    while (true) {
        if (void* const block = allocated(size)) return block;
        const std::new_handler freeSome = std::get_new_handler();
        if (freeSome == nullptr) throw std::bad_alloc();
        freeSome();
    }
}

void operator delete(void* block) noexcept {
    std::free(block);
}

void operator delete(void* block, std::size_t /*size*/) noexcept {
    std::free(block);
}
