/// \file Running other programs.
#include "base/error.h"
#include "cli/system/child_process.h"

#include <gtest/gtest.h>

#include <csignal>
#include <string>

namespace {

TEST(RunProgram, TellsAProgramThatIsMissingFromOneThatCannotBeStarted) {
    const qm::HeldSignals signals;
    EXPECT_TRUE(qm::runProgram({"true"}, signals));
    EXPECT_FALSE(qm::runProgram({"no-such-program"}, signals));
    EXPECT_THROW((void)qm::runProgram({"true", std::string(1 << 20, 'x')}, signals), qm::Error)
        << "an argument that is too long for the system";
}

TEST(HeldSignals, HoldAllThatEndATool) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGXCPU}) {
        const qm::HeldSignals signals;
        EXPECT_FALSE(qm::HeldSignals::oneWaits());
        raise(signal);
        EXPECT_TRUE(qm::HeldSignals::oneWaits()) << signal;
        std::signal(signal, SIG_IGN); // what waits is dropped
        std::signal(signal, SIG_DFL);
    }
}

} // namespace
