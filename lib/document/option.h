/// \file What an option of a tool is: a name, a member, what it may be, a help text.
///
/// Every options struct has one table of its options, a function template `describe(options, visitor)` in
/// options.h beside this file. Command lines, --help, --json-usage and the history in the documents are all
/// made from that table. Defaults are the struct's member initialisers and stand nowhere else.
///
/// A name is the long flag without its dashes: "max-turn". A `bool` that is true by default has the flag
/// "no-NAME".
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>

namespace qm {

/// The values that a number may have, both ends included. An infinite end is no limit.
struct Range {
    double min = -std::numeric_limits<double>::infinity();
    double max = std::numeric_limits<double>::infinity();
};

/// "0 to 3.14", "at least 1"; empty if any number will do.
[[nodiscard]] std::string rangeText(const Range& range);

/// One value of an enumeration as users write it.
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

/// The value of that name, written to `value`; false if there is none.
template <class Enum> [[nodiscard]] bool choiceValue(std::string_view name, Enum& value) {
    for (const Choice<Enum>& choice : Choices<Enum>::all) {
        if (choice.name != name) continue;
        value = choice.value;
        return true;
    }
    return false;
}

/// "max-turn" as a key of a document: "maxTurn".
[[nodiscard]] std::string keyOf(std::string_view optionName);

} // namespace qm
