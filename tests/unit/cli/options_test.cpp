/// \file The command line and what --help says of it.
#include "cli/options/command_line.h"
#include "cli/options/usage.h"
#include "document/json/json.h"
#include "support/message_of.h"

#include <gtest/gtest.h>

#include <set>

namespace {

using qm::test::messageOf;

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

TEST(CommandLine, TakesNoWordForAValueThatIsEmpty) {
    std::string mesh = "as it was", name;
    const std::vector<qm::OptionRecord> options{qm::makeTextOption("mesh", mesh, "FILE", "a mesh"),
                                                qm::makeTextOption("name", name, "NAME", "a name")};
    const auto read = [&options](std::vector<std::string> words) {
        std::vector<char*> pointers;
        for (std::string& word : words)
            pointers.push_back(word.data());
        return qm::readCommandLine(static_cast<int>(words.size()), pointers.data(), options);
    };
    const qm::CommandLine line = read({"qm-test", "--mesh=", "part.json"});
    EXPECT_EQ(line.problem, "--mesh: is empty");
    EXPECT_EQ(line.operands, std::vector<std::string>{"part.json"});
    EXPECT_EQ(mesh, "as it was");
    EXPECT_EQ(read({"qm-test", "--name=a", "--mesh=part.obj", "--", "--mesh="}).operands,
              std::vector<std::string>{"--mesh="});
    EXPECT_EQ(mesh, "part.obj");
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

} // namespace
