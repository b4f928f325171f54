/// \file Running independent pieces of work on several threads.
#pragma once

#include <algorithm>
#include <cstddef>
#include <exception>
#include <functional>
#include <thread>
#include <vector>

namespace qm {

/// Starts the wanted number of threads, or fewer if the system has no more. They hold copies of the work.
std::vector<std::jthread> startThreads(std::size_t wanted, const std::function<void()>& work);

/// A piece of work that runs while the caller does something else, if two threads are allowed; otherwise it
/// runs at once.
class Ahead {
public:
    Ahead(unsigned jobs, const std::function<void()>& work);

    Ahead(const Ahead&) = delete;
    Ahead& operator=(const Ahead&) = delete;

    /// Waits for the end of the work, and throws what it threw.
    void wait();

private:
    std::exception_ptr failure_;
    std::vector<std::jthread> threads_;
};

/// Calls f(0) ... f(count - 1), each once, on at most `jobs` threads including the caller's. The order is not
/// defined, so f must write only to what belongs to its index; then the result does not depend on `jobs`. If
/// calls throw, the exception with the lowest index is thrown on, and calls not yet begun may be left out.
void parallelFor(std::size_t count, unsigned jobs, const std::function<void(std::size_t)>& f);

/// The same for many small calls, which are grouped into blocks.
template <class Function> void parallelForMany(std::size_t count, unsigned jobs, const Function& f) {
    constexpr std::size_t block = 2048;
    parallelFor((count + block - 1) / block, jobs, [&](std::size_t number) {
        for (std::size_t k = number * block; k < std::min(count, (number + 1) * block); ++k)
            f(k);
    });
}

} // namespace qm
