/// \file Running independent pieces of work on several threads.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace qm {

/// Starts the wanted number of threads, or fewer if the system has no more.
template <class Function> std::vector<std::jthread> startThreads(std::size_t wanted, const Function& work) {
    std::vector<std::jthread> threads;
    threads.reserve(wanted);
    try {
        while (threads.size() < wanted)
            threads.emplace_back(work);
    } catch (const std::system_error&) { // not enough memory or processes
    }
    return threads;
}

/// A piece of work that runs while the caller does something else, if two threads are allowed; otherwise it
/// runs at once.
class Ahead {
public:
    template <class Function> Ahead(unsigned jobs, const Function& work) {
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

    Ahead(const Ahead&) = delete;
    Ahead& operator=(const Ahead&) = delete;

    /// Waits for the end of the work, and throws what it threw.
    void wait() {
        threads_.clear();
        if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
    }

private:
    std::exception_ptr failure_;
    std::vector<std::jthread> threads_;
};

/// Calls f(0) ... f(count - 1), each once, on at most `jobs` threads including the caller's. The order is not
/// defined, so f must write only to what belongs to its index; then the result does not depend on `jobs`. If
/// calls throw, the exception with the lowest index is thrown on, and calls not yet begun may be left out.
template <class Function> void parallelFor(std::size_t count, unsigned jobs, const Function& f) {
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

/// The same for many small calls, which are grouped into blocks.
template <class Function> void parallelForMany(std::size_t count, unsigned jobs, const Function& f) {
    constexpr std::size_t block = 2048;
    parallelFor((count + block - 1) / block, jobs, [&](std::size_t number) {
        for (std::size_t k = number * block; k < std::min(count, (number + 1) * block); ++k)
            f(k);
    });
}

} // namespace qm
