#include "cli/system/signals.h"

#include "base/error.h"

#include <climits>

#include <array>
#include <atomic>
#include <csignal>
#include <cstring>
#include <ctime>
#include <exception>
#include <new>
#include <unistd.h>

namespace qm {

namespace {

// Data that a signal handler may touch: lock-free flags, and memory that never moves.
struct TemporaryFile {
    std::atomic<bool> inUse{false};
    std::array<char, PATH_MAX> path{};
};
std::array<TemporaryFile, 4> temporaryFiles;
std::atomic<bool> deferring{false};
std::atomic<bool> interrupted{false};
std::atomic<long> interruptedAt{0}; ///< seconds of a monotonic clock
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<long>::is_always_lock_free);

long secondsNow() {
    struct timespec now {};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return static_cast<long>(now.tv_sec);
}

/// timeout(1) and batch systems send their signal both to the process and to its group, which counts as one
/// request. The limit on processor time repeats its signal every second.
bool mayGoOn(int signal) {
    if (!deferring || (signal != SIGINT && signal != SIGTERM && signal != SIGXCPU)) return false;
    if (!interrupted.exchange(true)) interruptedAt = secondsNow();
    return signal == SIGXCPU || secondsNow() - interruptedAt <= 1;
}

void removeTemporaryFiles() {
    for (const TemporaryFile& file : temporaryFiles)
        if (file.inUse) unlink(file.path.data());
}

extern "C" void onSignal(int signal) {
    if (mayGoOn(signal)) return;
    removeTemporaryFiles();
    std::signal(signal, SIG_DFL);
    raise(signal); // pending until this handler returns, and then ends the process with the right status
}

std::terminate_handler otherwise = nullptr;
std::string outOfMemory; ///< the message, made while there is memory

/// Libraries allocate memory even where exceptions are not allowed, such as in the destructor of a JSON
/// value.
[[noreturn]] void onTerminate() {
    try {
        if (const std::exception_ptr last = std::current_exception()) std::rethrow_exception(last);
    } catch (const std::bad_alloc&) {
        removeTemporaryFiles();
        [[maybe_unused]] const ssize_t ignored = write(STDERR_FILENO, outOfMemory.data(), outOfMemory.size());
        _exit(1);
    } catch (...) {
    }
    removeTemporaryFiles();
    otherwise();
    _exit(1); // not reached
}

} // namespace

void watchMemory(const std::string& tool) {
    outOfMemory = tool + ": out of memory. Ask for less, or use a machine with more\n";
    if (otherwise == nullptr) otherwise = std::set_terminate(onTerminate);
}

void watchSignals() {
    std::signal(SIGXFSZ, SIG_IGN); // writing beyond the limit on file sizes then fails, which is reported
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGXCPU, SIGQUIT}) {
        struct sigaction before {};
        if (sigaction(signal, nullptr, &before) != 0 || before.sa_handler == SIG_IGN) continue;
        struct sigaction action {};
        action.sa_handler = onSignal;
        action.sa_flags = SA_RESTART;
        sigemptyset(&action.sa_mask);
        sigaction(signal, &action, nullptr);
    }
}

void deferInterrupt() {
    deferring = true;
}

bool wasInterrupted() {
    return interrupted;
}

void registerTemporaryFile(const std::string& path) {
    for (TemporaryFile& file : temporaryFiles) {
        if (file.inUse || path.size() >= file.path.size()) continue;
        std::memcpy(file.path.data(), path.c_str(), path.size() + 1);
        file.inUse = true;
        return;
    }
    throw Error(path, "cannot be watched for signals");
}

void forgetTemporaryFile(const std::string& path) {
    for (TemporaryFile& file : temporaryFiles)
        if (file.inUse && path == file.path.data()) file.inUse = false;
}

} // namespace qm
