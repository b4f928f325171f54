/// \file An option bound to a variable, in the form used by the parser, --help and --json-usage.
#pragma once

#include "base/length.h"
#include "document/options/option.h"

#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace qm {

struct CostTerms;

struct OptionRecord {
    enum class Type { flag, integer, number, choice, text };

    std::string name;        ///< long name without dashes, but with "no-"
    std::string shortName;   ///< one letter; may be empty
    std::string placeholder; ///< such as "N" or "FILE"; empty for a flag
    std::string help;
    std::string group; ///< its heading in --help
    Type type = Type::text;
    Range range;                                              ///< for numbers
    std::vector<std::pair<std::string, std::string>> choices; ///< name and help of each choice
    std::vector<std::string> suggestions;                     ///< for texts: parts of a list worth suggesting
    std::string defaultText;                                  ///< empty if there is none
    /// Sets the variable.
    /// \return what is wrong with the text; empty if nothing is
    std::function<std::string(const std::string& text)> assign;
    std::function<std::string()> show; ///< the present value of the variable
};

[[nodiscard]] OptionRecord makeOption(const std::string& name, bool& value, const Range& range,
                                      const std::string& help);
/// \param value  an int, unsigned, std::size_t or double
template <class Number>
requires std::is_arithmetic_v<Number>
[[nodiscard]] OptionRecord makeOption(const std::string& name, Number& value, const Range& range,
                                      const std::string& help);
[[nodiscard]] OptionRecord makeOption(const std::string& name, Length& value, const Range& range,
                                      const std::string& help);
[[nodiscard]] OptionRecord makeTextOption(const std::string& name, std::string& value,
                                          const std::string& placeholder, const std::string& help);
[[nodiscard]] OptionRecord makeOption(const std::string& name, CostTerms& value, const Range& range,
                                      const std::string& help);
/// The record of an enumeration, apart from what depends on its type.
[[nodiscard]] OptionRecord makeChoiceOption(const std::string& name, const std::string& help,
                                            std::vector<std::pair<std::string, std::string>> choices,
                                            std::function<bool(std::string_view)> assign,
                                            std::function<std::string()> show);

template <class Enum>
requires std::is_enum_v<Enum>
[[nodiscard]] OptionRecord makeOption(const std::string& name, Enum& value, const Range&,
                                      const std::string& help) {
    std::vector<std::pair<std::string, std::string>> choices;
    choices.reserve(std::size(Choices<Enum>::all));
    for (const Choice<Enum>& choice : Choices<Enum>::all)
        choices.emplace_back(choice.name, choice.help);
    return makeChoiceOption(
        name, help, std::move(choices), [&value](std::string_view text) { return choiceValue(text, value); },
        [&value] { return std::string(choiceName(value)); });
}

} // namespace qm
