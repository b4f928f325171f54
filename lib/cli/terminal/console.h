/// \file Output of a running tool on standard error: messages, and a progress bar that makes room for them.
#pragma once

#include "base/control.h"
#include "cli/options/general_options.h"
#include "cli/terminal/progress.h"

#include <functional>
#include <memory>
#include <string>

namespace qm {

class Console {
public:
    /// \param options  must outlive this; its `quiet` and `verbose` apply as they are at each message
    Console(const std::string& tool, const GeneralOptions& options) : tool_(tool), options_(options) {}

    /// Prints one line, `tool: message`, with any options.
    void say(const std::string& message) const;
    /// Prints a message, unless --quiet is given.
    void warn(const std::string& message) const;
    /// Prints a message if --verbose is given.
    void note(const std::string& message) const;
    /// A function that prints the known cost and bound every few seconds; empty with --quiet.
    [[nodiscard]] KnownCost sayingKnown() const;

    /// Starts a progress bar in place of the previous one. It appears after two seconds.
    /// \return a function that updates the bar; empty with --quiet, and if standard error is no terminal
    [[nodiscard]] std::function<void(double fraction)> showProgress(const std::string& label);
    /// Removes the bar before other output to the terminal.
    void hideProgress() const;

private:
    std::string tool_;
    const GeneralOptions& options_;
    std::shared_ptr<Progress> progress_;
};

} // namespace qm
