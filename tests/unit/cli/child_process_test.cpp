/// \file Running other programs.
#include "base/error.h"
#include "cli/system/child_process.h"
#include "support/message_of.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <string>

namespace {

TEST(RunProgram, TellsAProgramThatIsMissingFromOneThatCannotBeStarted) {
    const qm::HeldSignals signals;
    EXPECT_TRUE(qm::runProgram({"true"}, signals));
    EXPECT_FALSE(qm::runProgram({"no-such-program"}, signals));
    EXPECT_THROW((void)qm::runProgram({"true", std::string(1 << 20, 'x')}, signals), qm::Error)
        << "an argument that is too long for the system";
}

TEST(TemporaryFolder, IsAbsoluteAndNamesTheRemedy) {
    const char* const present = std::getenv("TMPDIR");
    const std::string before = present == nullptr ? "/tmp" : present;
    setenv("TMPDIR", ".", 1);
    EXPECT_TRUE(qm::TemporaryFolder("qm-test").file("x").starts_with('/'));
    setenv("TMPDIR", "/no-such-folder", 1);
    EXPECT_EQ(qm::test::messageOf([] { const qm::TemporaryFolder folder("qm-test"); }),
              "no temporary folder can be made. Set TMPDIR to a folder that can be written");
    setenv("TMPDIR", before.c_str(), 1);
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
