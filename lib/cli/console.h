/// \file What a tool says on standard error while it runs: messages and a progress bar, which gives way to
/// them.
#pragma once

#include "base/known_cost.h"
#include "cli/general_options.h"
#include "cli/progress.h"

#include <functional>
#include <memory>
#include <string>

namespace qm {

class Console {
public:
    /// \param options  `quiet` and `verbose` as they are when something is said; must outlive this
    Console(const std::string& tool, const GeneralOptions& options) : tool_(tool), options_(options) {}

    /// One line, `tool: message`, whatever the options.
    void say(const std::string& message) const;
    /// Not with --quiet.
    void warn(const std::string& message) const;
    /// With --verbose only.
    void note(const std::string& message) const;
    /// Says every few seconds what a search tells it; none with --quiet.
    [[nodiscard]] KnownCost sayingKnown() const;

    /// Begins a bar, in the place of the one before. The bar appears after two seconds.
    /// \return shows the fraction done; none with --quiet, and where standard error is no terminal
    [[nodiscard]] std::function<void(double fraction)> showProgress(const std::string& label);
    /// Takes the bar away before something else is written to the terminal.
    void hideProgress() const;

private:
    std::string tool_;
    const GeneralOptions& options_;
    std::shared_ptr<Progress> progress_;
};

} // namespace qm
