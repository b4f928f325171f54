/// \file Signals and lack of memory: no half-written file is left behind, and a long search can end with its
/// best result so far.
#pragma once

#include <csignal>
#include <string>

namespace qm {

/// Blocks signals during its lifetime; those that come are delivered at its end.
class BlockedSignals {
public:
    explicit BlockedSignals(const sigset_t& signals) { pthread_sigmask(SIG_BLOCK, &signals, &before_); }
    ~BlockedSignals() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
    BlockedSignals(const BlockedSignals&) = delete;
    BlockedSignals& operator=(const BlockedSignals&) = delete;

    /// The signals that were blocked before.
    [[nodiscard]] const sigset_t& before() const { return before_; }

private:
    sigset_t before_{};
};

/// From now on signals that end the process remove its temporary files first. Signals ignored by the parent
/// process stay ignored. Writing beyond the limit on file sizes fails like any other write.
void watchSignals();

/// From now on a lack of memory is reported in one line even where exceptions cannot report it.
void watchMemory(const std::string& tool);

/// Lets the next interrupt, and any others within a second of it, only set `wasInterrupted`; a later one ends
/// the process.
void deferInterrupt();
[[nodiscard]] bool wasInterrupted();

/// Registers a file to be removed by a signal. Throws Error if there are too many.
void registerTemporaryFile(const std::string& path);
void forgetTemporaryFile(const std::string& path);

} // namespace qm
