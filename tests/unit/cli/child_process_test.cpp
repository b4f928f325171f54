/// \file Running other programs.
#include "base/error.h"
#include "cli/system/child_process.h"

#include <gtest/gtest.h>

namespace {

TEST(RunProgram, TellsAProgramThatIsMissingFromOneThatCannotBeStarted) {
    const qm::HeldSignals signals;
    EXPECT_TRUE(qm::runProgram({"true"}, signals));
    EXPECT_FALSE(qm::runProgram({"no-such-program"}, signals));
    EXPECT_THROW((void)qm::runProgram({"true", std::string(1 << 20, 'x')}, signals), qm::Error)
        << "an argument that is too long for the system";
}

} // namespace
