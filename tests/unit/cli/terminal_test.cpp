/// \file Messages and progress on standard error.
#include "cli/terminal/console.h"
#include "cli/terminal/messages.h"
#include "cli/terminal/progress.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

TEST(PrintMessage, ShortensBetweenCharacters) {
    for (int begin = 0; begin < 2; ++begin) {
        std::string message(static_cast<std::size_t>(begin), 'x');
        for (int k = 0; k < 3000; ++k)
            message += "\u00e9";
        ::testing::internal::CaptureStderr();
        qm::printMessage(message);
        const std::string printed = ::testing::internal::GetCapturedStderr();
        EXPECT_LE(printed.size(), 4005U);
        EXPECT_TRUE(printed.ends_with("\u00e9 ...\n")) << printed.substr(printed.size() - 10);
    }
}

TEST(Progress, TellsTheTimeThatIsLeft) {
    EXPECT_EQ(qm::progressText("cutting", 0.25, 10, 200),
              "cutting [======                  ] 25%, about 30 s left");
    EXPECT_EQ(qm::progressText("cutting", 0.5, 100, 200),
              "cutting [============            ] 50%, about 1 min 40 s left");
    EXPECT_EQ(qm::progressText("cutting", 0.5, 7300, 200).substr(40), "about 2 h 1 min left");
    EXPECT_EQ(qm::progressText("cutting", 0, 10, 200), "cutting [                        ] 0%");
    EXPECT_EQ(qm::progressText("cutting", std::nan(""), 10, 12), "cutting [   ");
}

TEST(Console, SaysWhatTheOptionsAllow) {
    qm::GeneralOptions options;
    qm::Console console("qm-test", options);
    const auto said = [&] {
        ::testing::internal::CaptureStderr();
        console.warn("warning");
        console.note("note");
        return ::testing::internal::GetCapturedStderr();
    };
    EXPECT_EQ(said(), "qm-test: warning\n");
    options.verbose = true;
    EXPECT_EQ(said(), "qm-test: warning\nqm-test: note\n");
    EXPECT_TRUE(console.sayingKnown() != nullptr);
    options.quiet = true;
    EXPECT_EQ(said(), "");
    EXPECT_TRUE(console.sayingKnown() == nullptr);
    EXPECT_TRUE(console.showProgress("working") == nullptr);
}

} // namespace
