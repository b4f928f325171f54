#include "cli/options/usage.h"

#include "base/at.h"
#include "base/joined.h"
#include "base/number_text.h"
#include "document/json/json.h"
#include "document/version.h"

#include <cmath>
#include <sstream>

namespace qm {

namespace {

constexpr std::size_t lineWidth = 96;
constexpr std::size_t helpColumn = 26;

/// Breaks words into lines of at most `lineWidth` columns; all lines but the first are indented.
std::string wrapped(const std::string& text, std::size_t indent, std::size_t column) {
    std::istringstream words(text);
    std::string result;
    for (std::string word; words >> word; column += word.size()) {
        if (column > indent) {
            if (column + 1 + word.size() > lineWidth) {
                result += "\n" + std::string(indent, ' ');
                column = indent;
            } else {
                result += ' ';
                ++column;
            }
        }
        result += word;
    }
    return result;
}

std::string flagsOf(const OptionRecord& option) {
    std::string flags = option.shortName.empty() ? "      " : "  -" + option.shortName + ", ";
    flags += "--" + option.name;
    if (!option.placeholder.empty()) flags += " " + option.placeholder;
    return flags;
}

/// The help text with choices, range and default.
std::string explanation(const OptionRecord& option) {
    std::vector<std::string> facts;
    for (const auto& [name, help] : option.choices)
        facts.push_back(help.empty() ? name : std::string(name).append(": ").append(help));
    if (const std::string range = rangeText(option.range); !range.empty()) facts.push_back(range);
    if (!option.defaultText.empty()) facts.push_back("default " + option.defaultText);
    return facts.empty() ? option.help : option.help + " (" + joined(facts, "; ") + ")";
}

/// The help text begins in its own column, after at least two spaces, or on the next line.
std::string entry(const std::string& flags, const std::string& text) {
    std::string line = flags;
    if (line.size() + 2 > helpColumn)
        line += "\n" + std::string(helpColumn, ' ');
    else
        line += std::string(helpColumn - line.size(), ' ');
    return line + wrapped(text, helpColumn, helpColumn) + "\n";
}

std::string usageLine(const Usage& usage) {
    std::string line = "Usage: " + usage.tool + " [OPTION]...";
    for (const Operand& operand : usage.operands)
        line += operand.required ? " " + operand.name : " [" + operand.name + "]";
    return line + "\n";
}

Json describeOption(const OptionRecord& option) {
    static const char* const types[] = {"flag", "integer", "number", "choice", "text"};
    Json entry{{"name", "--" + option.name}};
    if (!option.shortName.empty()) entry["short"] = "-" + option.shortName;
    entry["group"] = option.group;
    entry["type"] = types[at(option.type)];
    if (!option.placeholder.empty()) entry["placeholder"] = option.placeholder;
    if (std::isfinite(option.range.min)) entry["minimum"] = option.range.min;
    if (std::isfinite(option.range.max)) entry["maximum"] = option.range.max;
    for (const auto& [name, help] : option.choices)
        entry["choices"].push_back({{"name", name}, {"help", help}});
    if (!option.suggestions.empty()) entry["suggestions"] = option.suggestions;
    if (double number = 0; parseNumber(option.defaultText, number))
        entry["default"] = number;
    else if (!option.defaultText.empty())
        entry["default"] = option.defaultText;
    entry["help"] = option.help;
    return entry;
}

} // namespace

std::string helpText(const Usage& usage) {
    std::string text = usage.summary + "\n\n" + usageLine(usage);
    for (const std::string& paragraph : usage.paragraphs)
        text += "\n" + wrapped(paragraph, 0, 0) + "\n";
    if (!usage.operands.empty() || !usage.writes.empty()) text += "\n";
    for (const Operand& operand : usage.operands)
        text += wrapped(operand.name + " is " + operand.help + ".", 0, 0) + "\n";
    if (!usage.writes.empty()) text += wrapped("Writes " + usage.writes + ".", 0, 0) + "\n";

    std::string group;
    for (const OptionRecord& option : usage.options) {
        if (option.group != group) text += "\n" + option.group + ":\n";
        group = option.group;
        text += entry(flagsOf(option), explanation(option));
    }
    if (!usage.examples.empty()) text += "\nExamples:\n";
    for (const std::string& example : usage.examples)
        text += "  " + example + "\n";
    return text;
}

std::string jsonUsage(const Usage& usage) {
    Json root{{"name", usage.tool},
              {"version", version()},
              {"summary", usage.summary},
              {"description", usage.paragraphs}};
    root["operands"] = Json::array();
    for (const Operand& operand : usage.operands) {
        root["operands"].push_back(
            {{"name", operand.name}, {"help", operand.help}, {"required", operand.required}});
        if (!operand.suggestions.empty()) root["operands"].back()["suggestions"] = operand.suggestions;
    }
    root["writes"] = usage.writes;
    if (!usage.schema.empty()) root["kind"] = usage.schema;
    root["options"] = Json::array();
    for (const OptionRecord& option : usage.options)
        root["options"].push_back(describeOption(option));
    root["examples"] = usage.examples;
    return printJson(root);
}

std::string versionText(const std::string& tool) {
    return tool + " (quadmesh) " + version() +
           "\nbuilt with "
#ifndef __clang__
           "g++ "
#endif
           __VERSION__
#ifdef NDEBUG
           ", optimised"
#endif
           "\nLicence MIT. There is no warranty.\n";
}

} // namespace qm
