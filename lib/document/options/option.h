/// \file The description of a tool's option: its name, the member it sets, its values, its help text.
///
/// Every options struct has one table of its options, a function template `describe(options, visitor)` in
/// options.h. Command lines, --help, --json-usage and the history in documents are all derived from that
/// table. Defaults are the struct's member initialisers, and are stated nowhere else.
///
/// A name is the long flag without its dashes: "max-turn". A `bool` that is true by default has the flag
/// "no-NAME".
#pragma once

#include "base/infinity.h"
#include "base/length.h"

#include <string>
#include <string_view>

namespace qm {

/// The allowed values of a number, including both ends. An infinite end means no limit.
struct Range {
    double min = -infinity;
    double max = infinity;
};

/// "0 to 3.14", "at least 1"; empty if there is no limit.
[[nodiscard]] std::string rangeText(const Range& range);

/// A length as users and documents write it: "0.1%" or "0.05".
[[nodiscard]] std::string lengthText(const Length& length);
/// Reads a whole text as a number, not negative, with or without %. If it is anything else, returns false and
/// leaves `length` unchanged.
[[nodiscard]] bool parseLength(std::string_view text, Length& length);

/// A value of an enumeration with its name on the command line.
template <class Enum> struct Choice {
    Enum value;
    std::string_view name;
    std::string_view help;
};

/// The choices of an enumeration; specialised in options.h.
template <class Enum> struct Choices;

/// The name of an enumeration's value.
template <class Enum> [[nodiscard]] std::string_view choiceName(Enum value) {
    for (const Choice<Enum>& choice : Choices<Enum>::all)
        if (choice.value == value) return choice.name;
    return {};
}

/// Finds the value with a name; false if there is none.
template <class Enum> [[nodiscard]] bool choiceValue(std::string_view name, Enum& value) {
    for (const Choice<Enum>& choice : Choices<Enum>::all) {
        if (choice.name != name) continue;
        value = choice.value;
        return true;
    }
    return false;
}

/// The key of an option in documents: "maxTurn" for "max-turn".
[[nodiscard]] std::string keyOf(std::string_view optionName);

} // namespace qm
