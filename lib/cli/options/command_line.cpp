#include "cli/options/command_line.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cctype>

namespace qm {
namespace {

std::string withSmallStart(std::string text) {
    if (!text.empty()) text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
    return text;
}

/// The words of a command line, the last one first, as CLI11 takes them. It would take the word behind
/// "--mesh=" for the value, which is empty, and "--quiet=true" for "--quiet".
/// \param problem  set if a flag has a value
std::vector<std::string> wordsOf(int argc, char** argv, const std::vector<OptionRecord>& options,
                                 std::string& problem) {
    std::vector<std::string> words;
    bool mayBeOption = true;
    for (int k = 1; k < argc; ++k) {
        std::string word = argv[k];
        mayBeOption = mayBeOption && word != "--";
        const std::size_t equals = mayBeOption ? word.find('=') : std::string::npos;
        const auto option = std::ranges::find(options, word.substr(0, equals),
                                              [](const OptionRecord& known) { return "--" + known.name; });
        const bool isKnown = equals != std::string::npos && option != options.end();
        if (isKnown && option->type == OptionRecord::Type::flag)
            problem = "--" + option->name + ": takes no value";
        const bool isSplit = isKnown && equals + 1 == word.size();
        if (isSplit) word.pop_back();
        words.push_back(std::move(word));
        if (isSplit && option->type != OptionRecord::Type::flag) words.emplace_back();
    }
    std::ranges::reverse(words);
    return words;
}

void parse(CLI::App& app, std::vector<std::string> words) {
    try {
        app.parse(std::move(words));
    } catch (const CLI::ArgumentMismatch& error) {
        const std::string what = error.what(); // such as "--output: 1 required FILE missing"
        throw UsageError(what.substr(0, what.find(':')) + ": its value is missing");
    } catch (const CLI::ParseError& error) {
        throw UsageError(withSmallStart(error.what()));
    }
}

/// Collects the remaining words: operands, and unknown options until "--" ends the options.
void takeOperands(const std::vector<std::string>& words, CommandLine& line) {
    bool operandsOnly = false;
    for (const std::string& word : words) {
        if (operandsOnly || word.size() < 2 || word[0] != '-')
            line.operands.push_back(word);
        else if (word == "--")
            operandsOnly = true;
        else if (line.problem.empty())
            line.problem = "unknown option " + word;
    }
}

} // namespace

CommandLine readCommandLine(int argc, char** argv, const std::vector<OptionRecord>& options) {
    CLI::App app;
    app.set_help_flag();
    app.allow_extras();
    std::vector<std::string> texts(options.size());
    std::vector<CLI::Option*> bound(options.size());
    for (std::size_t i = 0; i < options.size(); ++i) {
        const OptionRecord& option = options[i];
        const std::string flags =
            (option.shortName.empty() ? "" : "-" + option.shortName + ",") + "--" + option.name;
        if (option.type == OptionRecord::Type::flag)
            bound[i] = app.add_flag(flags);
        else
            bound[i] = app.add_option(flags, texts[i])->type_name(option.placeholder);
        bound[i]->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
    }
    CommandLine line;
    parse(app, wordsOf(argc, argv, options, line.problem));
    for (std::size_t i = 0; i < options.size(); ++i) {
        if (bound[i]->count() == 0) continue;
        line.given.insert(options[i].name);
        const std::string problem = options[i].assign(texts[i]);
        if (!problem.empty() && line.problem.empty()) line.problem = "--" + options[i].name + ": " + problem;
    }
    takeOperands(app.remaining(), line);
    return line;
}

void assignOperands(const std::vector<std::string>& words, const std::vector<Operand>& declared,
                    const std::vector<std::string*>& targets, std::vector<std::string>* more) {
    for (std::size_t i = 0; i < words.size(); ++i) {
        const bool isMore = i >= targets.size();
        if (isMore && more == nullptr) throw UsageError("unexpected operand " + words[i]);
        if (words[i].empty())
            throw UsageError((isMore ? "operand " + std::to_string(i + 1) : declared[i].name) + " is empty");
        if (isMore)
            more->push_back(words[i]);
        else
            *targets[i] = words[i];
    }
    for (std::size_t i = words.size(); i < declared.size(); ++i)
        if (declared[i].required) throw UsageError(declared[i].name + " is missing");
}

void requireEffects(const std::vector<OptionCondition>& conditions, const std::set<std::string>& given) {
    for (const OptionCondition& condition : conditions)
        for (const std::string& name : condition.names)
            if (given.contains(name) && !condition.holds())
                throw UsageError("--" + name + " has no effect without " + condition.what + ". Leave it out");
}

} // namespace qm
