#include "base/parallel.h"

#include <atomic>
#include <mutex>
#include <system_error>
#include <utility>

namespace qm {

std::vector<std::jthread> startThreads(std::size_t wanted, const std::function<void()>& work) {
    std::vector<std::jthread> threads;
    threads.reserve(wanted);
    try {
        while (threads.size() < wanted)
            threads.emplace_back(work);
    } catch (const std::system_error&) { // not enough memory or processes
    }
    return threads;
}

Ahead::Ahead(unsigned jobs, const std::function<void()>& work) {
    const auto guarded = [this, work] {
        try {
            work();
        } catch (...) {
            failure_ = std::current_exception();
        }
    };
    if (jobs > 1) threads_ = startThreads(1, guarded);
    if (threads_.empty()) guarded();
}

void Ahead::wait() {
    threads_.clear();
    if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
}

void parallelFor(std::size_t count, unsigned jobs, const std::function<void(std::size_t)>& f) {
    std::atomic<std::size_t> next{0};
    std::atomic<std::size_t> failedIndex{count};
    std::mutex mutex;
    std::exception_ptr failure;

    const auto work = [&] {
        // Calls below a failed one go on, as the lowest failure is the one to report.
        for (std::size_t i = next++; i < failedIndex; i = next++) {
            try {
                f(i);
            } catch (...) {
                const std::lock_guard<std::mutex> lock(mutex);
                if (i < failedIndex) {
                    failedIndex = i;
                    failure = std::current_exception();
                }
            }
        }
    };

    const std::size_t helpers =
        std::min<std::size_t>(std::max(jobs, 1U), std::max<std::size_t>(count, 1)) - 1;
    {
        const std::vector<std::jthread> threads = startThreads(helpers, work);
        work();
    }
    if (failure) std::rethrow_exception(failure);
}

} // namespace qm
