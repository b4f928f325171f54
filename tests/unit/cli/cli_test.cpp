/// \file Parts of the command line that need no process of their own; tests/cli tests the rest.
#include "base/error.h"
#include "cli/options/command_line.h"
#include "cli/options/usage.h"
#include "cli/system/exit_status.h"
#include "cli/system/output_file.h"
#include "cli/terminal/console.h"
#include "cli/terminal/messages.h"
#include "cli/terminal/progress.h"
#include "cli/tool.h"
#include "document/files/files.h"
#include "document/json/json.h"
#include "support/message_of.h"
#include "support/sample_document.h"

#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <functional>
#include <memory>
#include <new>
#include <set>
#include <stdexcept>

namespace {

namespace files = std::filesystem;
using qm::OutputFile;
using qm::test::messageOf;
using qm::test::TemporaryFolder;

std::size_t entries(const TemporaryFolder& folder) {
    const files::directory_iterator all(folder.file(""));
    return static_cast<std::size_t>(std::distance(files::begin(all), files::end(all)));
}

TEST(OutputFile, AppearsWholeOrNotAtAll) {
    const TemporaryFolder folder;
    const std::string path = folder.write("out", "as it was");
    {
        OutputFile file(path);
        file.write(std::string(1 << 20, 'x'));
        EXPECT_EQ(qm::readFile(path), "as it was");
    }
    EXPECT_EQ(qm::readFile(path), "as it was");
    EXPECT_EQ(entries(folder), 1U);
    OutputFile file(path);
    file.write("new ");
    file.write("text");
    file.commit();
    EXPECT_EQ(qm::readFile(path), "new text");
    EXPECT_EQ(entries(folder), 1U);
}

TEST(OutputFile, LeavesNothingWhereTooManyAreOpen) {
    const TemporaryFolder folder;
    {
        std::vector<std::unique_ptr<OutputFile>> open;
        const auto openAnother = [&] {
            open.push_back(std::make_unique<OutputFile>(folder.file("out" + std::to_string(open.size()))));
        };
        while (messageOf(openAnother).empty() && open.size() < 100) {
        }
        EXPECT_EQ(entries(folder), open.size());
        sigset_t blocked;
        pthread_sigmask(SIG_BLOCK, nullptr, &blocked);
        EXPECT_EQ(sigismember(&blocked, SIGTERM), 0);
    }
    EXPECT_EQ(entries(folder), 0U);
}

TEST(OutputFile, FollowsLinksAndKeepsPermissions) {
    const TemporaryFolder folder;
    const std::string target = folder.write("target", "old");
    files::permissions(target,
                       files::perms::owner_read | files::perms::owner_write | files::perms::group_read);
    const auto before = files::status(target).permissions();
    files::create_symlink(target, folder.file("link"));
    qm::writeFile(folder.file("link"), "new");
    EXPECT_TRUE(files::is_symlink(folder.file("link")));
    EXPECT_EQ(qm::readFile(target), "new");
    EXPECT_EQ(files::status(target).permissions(), before);
}

TEST(OutputFile, WritesToDevices) {
    EXPECT_NO_THROW(qm::writeFile("/dev/null", "text"));
    const std::string message = messageOf([] { qm::writeFile("/dev/full", std::string(1 << 20, 'x')); });
    EXPECT_EQ(message, "/dev/full: cannot be written: No space left on device");
}

TEST(OutputFile, SaysEarlyThatAPathIsImpossible) {
    const TemporaryFolder folder;
    EXPECT_EQ(messageOf([&] { qm::verifyWritable(folder.file("missing/out")); }),
              folder.file("missing/out") + ": cannot be written: there is no folder " +
                  folder.file("missing") + ". Make it first");
    EXPECT_EQ(messageOf([&] { qm::verifyWritable(folder.file("")); }).find(folder.file("")), 0U);
    EXPECT_NO_THROW(qm::verifyWritable(folder.file("new")));
    EXPECT_EQ(entries(folder), 0U);
}

TEST(OutputFile, SparesWhatIsProtected) {
    const TemporaryFolder folder;
    const std::string mesh = folder.write("mesh", "as it was");
    files::create_symlink(mesh, folder.file("link"));
    files::create_directory(folder.file("sub"));
    qm::protectFromOutput(folder.file("sub/../mesh"), "is needed");
    for (const char* name : {"mesh", "link", "./mesh", "sub/../link"}) {
        EXPECT_EQ(messageOf([&] { qm::writeFile(folder.file(name), "new"); }),
                  folder.file(name) + ": is needed. Name another file");
    }
    EXPECT_EQ(qm::readFile(mesh), "as it was");
    EXPECT_NO_THROW(qm::writeFile(folder.file("other"), "new"));
}

TEST(OutputFile, IsTheSameByAnyName) {
    const TemporaryFolder folder;
    files::create_symlink(folder.write("file", ""), folder.file("link"));
    files::create_directory(folder.file("sub"));
    EXPECT_TRUE(qm::isSameFile(folder.file("link"), folder.file("file")));
    EXPECT_TRUE(qm::isSameFile(folder.file("new"), folder.file("sub/../new"))) << "neither exists";
    EXPECT_FALSE(qm::isSameFile(folder.file("new"), folder.file("file")));
    EXPECT_TRUE(qm::isSameFile("-", "-"));
    EXPECT_FALSE(qm::isSameFile("-", folder.file("file")));
}

TEST(ReadFile, NamesWhatCannotBeRead) {
    const TemporaryFolder folder;
    EXPECT_EQ(messageOf([&] { (void)qm::readFile(folder.file("none")); }),
              folder.file("none") + ": cannot be read: No such file or directory");
    EXPECT_EQ(messageOf([&] { (void)qm::readFile(folder.file("")); }),
              folder.file("") + ": is a folder. Name a file");
    const std::string bytes(300000, '\0');
    EXPECT_EQ(qm::readFile(folder.write("zeros", bytes)), bytes);
    EXPECT_EQ(qm::readFile(folder.write("empty", "")), "");
}

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

TEST(Usage, HelpAndJsonSayTheSame) {
    qm::Usage usage;
    usage.tool = "qm-test";
    usage.summary = "Test something.";
    usage.operands = {{"DOCUMENT", "a document", false, {}}};
    usage.writes = "nothing";
    double value = 0.5;
    usage.options.push_back(qm::makeOption("rho", value, {0, 3}, "an angle"));
    usage.options.back().group = "Options";
    usage.options.back().shortName = "r";
    usage.examples = {"qm-test --rho 1 part.json"};
    EXPECT_EQ(qm::helpText(usage), "Test something.\n"
                                   "\n"
                                   "Usage: qm-test [OPTION]... [DOCUMENT]\n"
                                   "\n"
                                   "DOCUMENT is a document.\n"
                                   "Writes nothing.\n"
                                   "\n"
                                   "Options:\n"
                                   "  -r, --rho X             an angle (0 to 3; default 0.5)\n"
                                   "\n"
                                   "Examples:\n"
                                   "  qm-test --rho 1 part.json\n");
    const qm::Json json = qm::parseJson(qm::jsonUsage(usage));
    EXPECT_EQ(json["name"], "qm-test");
    EXPECT_EQ(json["options"][0], qm::parseJson(R"({"name": "--rho", "short": "-r", "group": "Options",
        "type": "number", "placeholder": "X", "minimum": 0, "maximum": 3, "default": 0.5,
        "help": "an angle"})"));
    EXPECT_EQ(json["examples"], usage.examples);
}

TEST(CommandLineRules, GiveWordsToOperandsInTheirOrder) {
    const std::vector<qm::Operand> declared{{"FIRST", "a", true, {}}, {"SECOND", "b", false, {}}};
    std::string first, second;
    std::vector<std::string> rest;
    const auto assign = [&](const std::vector<std::string>& words, std::vector<std::string>* more) {
        first.clear();
        second = "unset";
        rest.clear();
        return messageOf<qm::UsageError>([&] {
            qm::assignOperands(words, declared, {&first, &second}, more);
        });
    };
    EXPECT_EQ(assign({"x"}, nullptr), "");
    EXPECT_EQ(first + " " + second, "x unset");
    EXPECT_EQ(assign({"x", "y", "z", "-"}, &rest), "");
    EXPECT_EQ(second, "y");
    EXPECT_EQ(rest, (std::vector<std::string>{"z", "-"}));
    EXPECT_EQ(assign({}, &rest), "FIRST is missing");
    EXPECT_EQ(assign({"x", "y", "z"}, nullptr), "unexpected operand z");
    EXPECT_EQ(assign({"x", ""}, &rest), "SECOND is empty");
    EXPECT_EQ(assign({"x", "y", ""}, &rest), "operand 3 is empty");
}

TEST(CommandLineRules, RefuseOptionsWithoutEffect) {
    bool counting = false;
    const std::vector<qm::OptionCondition> conditions{
        {{"seed", "draws"}, "--count", [&] { return counting; }}};
    const auto refused = [&](const std::set<std::string>& given) {
        return messageOf<qm::UsageError>([&] { qm::requireEffects(conditions, given); });
    };
    EXPECT_EQ(refused({"best"}), "");
    EXPECT_EQ(refused({"best", "draws"}), "--draws has no effect without --count. Leave it out");
    counting = true;
    EXPECT_EQ(refused({"seed", "draws"}), "");
}

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
