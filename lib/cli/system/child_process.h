/// \file Running other programs, and temporary folders for their files.
#pragma once

#include "cli/system/signals.h"

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace qm {

/// Blocks the signals that end the process, so that nothing is left behind; a waiting one ends a child at
/// once.
class HeldSignals : public BlockedSignals {
public:
    HeldSignals();

    [[nodiscard]] static bool oneWaits();
};

/// A new folder, which is removed together with its contents.
class TemporaryFolder {
public:
    /// \param prefix  of the folder's name
    /// \throw Error  if the folder cannot be made
    explicit TemporaryFolder(const std::string& prefix);
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    /// The absolute path of a file in it.
    [[nodiscard]] std::string file(const std::string& name) const { return path_ + "/" + name; }

private:
    std::string path_;
};

/// Runs a program, which is found by PATH, without input, until it ends, a signal arrives, or `patience` is
/// over.
/// \param words     the program and its arguments
/// \param output    the file for what the program prints
/// \param patience  no limit if empty
/// \return false if there is no such program
/// \throw Error  if it cannot be started for another reason
[[nodiscard]] bool runProgram(std::vector<std::string> words, const HeldSignals& signals,
                              const std::string& output = "/dev/null",
                              std::optional<std::chrono::seconds> patience = {});

} // namespace qm
