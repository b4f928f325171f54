#include "cli/options/option_record.h"

#include "base/joined.h"
#include "base/number_text.h"
#include "document/options/cost_text.h"

#include <cmath>

namespace qm {

namespace {

OptionRecord record(OptionRecord::Type type, const std::string& name, const std::string& help) {
    OptionRecord result;
    result.type = type;
    result.name = name;
    result.help = help;
    return result;
}

template <class Number>
std::string assignNumber(const std::string& text, const Range& range, bool whole, Number& target) {
    Number value{};
    if (!parseNumber(text, value)) return "'" + text + (whole ? "' is no whole number" : "' is no number");
    const auto number = static_cast<double>(value);
    if (number < range.min || number > range.max) return text + " is out of range, " + rangeText(range);
    target = value;
    return {};
}

} // namespace

OptionRecord makeOption(const std::string& name, bool& value, const Range&, const std::string& help) {
    OptionRecord result = record(OptionRecord::Type::flag, value ? "no-" + name : name, help);
    result.assign = [&value, whenGiven = !value](const std::string&) {
        value = whenGiven;
        return std::string();
    };
    result.show = [&value, whenGiven = !value] { return std::string(value == whenGiven ? "yes" : "no"); };
    return result;
}

template <class Number>
requires std::is_arithmetic_v<Number> OptionRecord makeOption(const std::string& name, Number& value,
                                                              const Range& allowed, const std::string& help) {
    constexpr bool whole = std::is_integral_v<Number>;
    OptionRecord result =
        record(whole ? OptionRecord::Type::integer : OptionRecord::Type::number, name, help);
    Range range = allowed;
    if constexpr (std::is_unsigned_v<Number>) range.min = std::max(range.min, 0.0);
    result.range = range;
    result.placeholder = whole ? "N" : "X";
    const auto show = [&value] {
        const auto number = static_cast<double>(value);
        return std::isfinite(number) ? numberText(number) : std::string();
    };
    // A default that cannot be given stands for none, here and below.
    if (const auto number = static_cast<double>(value); number >= range.min && number <= range.max)
        result.defaultText = show();
    result.show = show;
    result.assign = [&value, range](const std::string& text) {
        return assignNumber(text, range, whole, value);
    };
    return result;
}

template OptionRecord makeOption(const std::string&, int&, const Range&, const std::string&);
template OptionRecord makeOption(const std::string&, unsigned&, const Range&, const std::string&);
template OptionRecord makeOption(const std::string&, std::size_t&, const Range&, const std::string&);
template OptionRecord makeOption(const std::string&, double&, const Range&, const std::string&);

OptionRecord makeOption(const std::string& name, Length& value, const Range& range, const std::string& help) {
    OptionRecord result = record(OptionRecord::Type::text, name, help);
    result.placeholder = "X[%]";
    if (value.value >= range.min) result.defaultText = lengthText(value);
    result.show = [&value] { return lengthText(value); };
    result.assign = [&value, range](const std::string& text) {
        Length length;
        if (!parseLength(text, length) || length.value < range.min)
            return "'" + text + "' is no " + (range.min > 0 ? "positive number" : "number from 0") +
                   ", with or without %";
        value = length;
        return std::string();
    };
    return result;
}

OptionRecord makeTextOption(const std::string& name, std::string& value, const std::string& placeholder,
                            const std::string& help) {
    OptionRecord result = record(OptionRecord::Type::text, name, help);
    result.placeholder = placeholder;
    result.defaultText = value;
    result.show = [&value] { return value; };
    result.assign = [&value](const std::string& text) {
        if (text.empty()) return std::string("is empty");
        value = text;
        return std::string();
    };
    return result;
}

OptionRecord makeOption(const std::string& name, CostTerms& value, const Range&, const std::string& help) {
    OptionRecord result = record(OptionRecord::Type::text, name, help);
    result.placeholder = "SUM";
    result.defaultText = costText(value);
    result.show = [&value] { return costText(value); };
    result.assign = [&value](const std::string& text) { return parseCost(text, value); };
    return result;
}

OptionRecord makeChoiceOption(const std::string& name, const std::string& help,
                              std::vector<std::pair<std::string, std::string>> choices,
                              std::function<bool(std::string_view)> assign,
                              std::function<std::string()> show) {
    OptionRecord result = record(OptionRecord::Type::choice, name, help);
    result.placeholder = "NAME";
    result.defaultText = show();
    result.show = std::move(show);
    const std::string names = joined(choices, ", ", [](const auto& choice) { return choice.first; });
    result.choices = std::move(choices);
    result.assign = [assign = std::move(assign), names](const std::string& text) {
        return assign(text) ? std::string() : "'" + text + "' is none of " + names;
    };
    return result;
}

} // namespace qm
