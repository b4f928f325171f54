/// \file Other programs that a tool sets to work, and the folder that it hands them files in.
#pragma once

#include <chrono>
#include <csignal>
#include <optional>
#include <string>
#include <vector>

namespace qm {

/// While it lives signals wait, so that nothing is left behind; a child is ended at once when one does.
class HeldSignals {
public:
    HeldSignals();
    ~HeldSignals();
    HeldSignals(const HeldSignals&) = delete;
    HeldSignals& operator=(const HeldSignals&) = delete;

    /// What the process blocked before.
    [[nodiscard]] const sigset_t& before() const { return before_; }
    [[nodiscard]] static bool oneWaits();

private:
    sigset_t before_;
};

/// A new folder, which goes with all that is in it.
class TemporaryFolder {
public:
    /// \param prefix  of its name
    /// \throw Error  if it cannot be made
    explicit TemporaryFolder(const std::string& prefix);
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    [[nodiscard]] std::string file(const char* name) const { return path_ + "/" + name; }

private:
    std::string path_;
};

/// Runs a program, which is looked for in PATH, without input, until it ends, a signal comes, or patience is
/// over.
/// \param words  the program and its arguments
/// \param output  the file that takes what it prints
/// \param patience  none: for as long as it takes
/// \return false if there is no such program
[[nodiscard]] bool runProgram(std::vector<std::string> words, const HeldSignals& signals,
                              const std::string& output = "/dev/null",
                              std::optional<std::chrono::seconds> patience = {});

} // namespace qm
