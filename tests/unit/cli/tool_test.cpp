/// \file The main that all tools share; tests/cli tests the rest.
#include "base/error.h"
#include "cli/options/command_line.h"
#include "cli/system/exit_status.h"
#include "cli/tool.h"
#include "document/files/files.h"
#include "support/sample_document.h"

#include <gtest/gtest.h>

#include <functional>
#include <new>
#include <stdexcept>

namespace {

using qm::test::TemporaryFolder;

TEST(ExitStatus, SaysWhatWentWrongInOneMessage) {
    std::string said;
    const auto status = [&](const std::function<int()>& work) {
        said.clear();
        return qm::statusOf(
            work, "qm-test", [] { return "part.json"; },
            [&](const std::string& message) { said += message; });
    };
    EXPECT_EQ(status([] { return 3; }), 3);
    EXPECT_EQ(said, "");
    EXPECT_EQ(status([]() -> int { throw qm::UsageError("wrong"); }), qm::exitUsage);
    EXPECT_EQ(said, "wrong. Try 'qm-test --help'.");
    EXPECT_EQ(status([]() -> int { throw qm::Error("/cut", "it is wrong", "Mend it"); }), qm::exitFailure);
    EXPECT_EQ(said, std::string("part.json: ") + qm::Error("/cut", "it is wrong", "Mend it").what());
    EXPECT_EQ(status([]() -> int { throw std::bad_alloc(); }), qm::exitFailure);
    EXPECT_EQ(said, "out of memory. Ask for less, or use a machine with more");
    EXPECT_EQ(status([]() -> int { throw std::logic_error("odd"); }), qm::exitFailure);
    EXPECT_EQ(said, "unexpected failure: odd. This is a fault of the tool: please report it");
}

/// Runs a tool in this process, with its output in a file.
/// \return its exit status
int runWith(std::vector<std::string> words, const std::function<qm::ToolBody(qm::Tool&)>& declare) {
    std::vector<char*> argv;
    argv.reserve(words.size() + 1);
    for (std::string& word : words)
        argv.push_back(word.data());
    argv.push_back(nullptr);
    return qm::runTool(static_cast<int>(words.size()), argv.data(), "qm-test", "Test.", declare);
}

TEST(Tool, ReadsItsCommandLineBeforeAnythingElse) {
    const TemporaryFolder folder;
    double value = 1;
    std::string extra;
    int runs = 0;
    const auto run = [&](std::vector<std::string> words) {
        value = 1;
        extra.clear();
        words.insert(words.begin(), "qm-test");
        return runWith(std::move(words), [&](qm::Tool& tool) -> qm::ToolBody {
            tool.operand("EXTRA", extra, "more");
            tool.reads("INPUT", "text");
            tool.writes("the same text");
            tool.option("value", value, {-5, 5}, "a number");
            return [&] {
                ++runs;
                tool.write(tool.readInput());
                return qm::exitDone;
            };
        });
    };
    const std::string input = folder.write("[in]", "text");
    const std::string output = folder.file("out");
    EXPECT_EQ(run({"-q", "first", input, "-o", output, "--value", "-3"}), 0);
    EXPECT_EQ(value, -3);
    EXPECT_EQ(extra, "first");
    EXPECT_EQ(qm::readFile(output), "text");
    EXPECT_EQ(run({"--value=2", "--value", "4", "-qo" + output, "--", "-first", input}), 0);
    EXPECT_EQ(value, 4);
    EXPECT_EQ(extra, "-first");
    EXPECT_EQ(runs, 2);
    for (const std::vector<std::string>& wrong : {std::vector<std::string>{},
                                                  {"first", input, "more"},
                                                  {"first", input, "--unknown"},
                                                  {"first", input, "-o"},
                                                  {"first", input, "--value", "6"},
                                                  {"first", input, "--value", "x"},
                                                  {"first", input, "--output", ""},
                                                  {"first", ""}})
        EXPECT_EQ(run(wrong), 2);
    EXPECT_EQ(run({"first", folder.file("none")}), 1);
    EXPECT_EQ(run({"first", input, "-o", folder.file("none/out")}), 1);
    EXPECT_EQ(runs, 3);
}

TEST(Tool, TurnsEveryExceptionIntoAStatus) {
    const auto status = [](const std::function<int()>& body) {
        return runWith({"qm-test"}, [&](qm::Tool&) -> qm::ToolBody { return body; });
    };
    EXPECT_EQ(status([] { return qm::exitUnmet; }), 3);
    EXPECT_EQ(status([]() -> int { throw qm::Error("place", "what", "Remedy"); }), 1);
    EXPECT_EQ(status([]() -> int { throw std::bad_alloc(); }), 1);
    EXPECT_EQ(status([]() -> int { throw std::logic_error("fault"); }), 1);
    EXPECT_EQ(status([]() -> int { throw qm::UsageError("wrong"); }), 2);
}

} // namespace
