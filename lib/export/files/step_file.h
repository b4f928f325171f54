/// \file The entities of a STEP file (ISO 10303-21), as text, in order.
#pragma once

#include <concepts>
#include <cstddef>
#include <ranges>
#include <string>
#include <string_view>

namespace qm {

/// The number of an entity, as others refer to it.
struct StepId {
    int number = 0;
};

/// A parameter that is written as it stands.
struct StepToken {
    std::string_view text;
};

inline constexpr StepToken derivedValue{"*"};
inline constexpr StepToken noValue{"$"};
inline constexpr StepToken unspecified{".UNSPECIFIED."};

/// The contents of a string, between its quotation marks. A comma is written by its code, because lines are
/// broken after commas.
/// \param utf8   valid UTF-8
/// \param limit  in bytes; characters beyond it are left out
[[nodiscard]] std::string stepText(std::string_view utf8, std::size_t limit = std::string_view::npos);

/// One parameter of an entity.
/// \param value  a number, with a decimal point and in the fewest digits that read back as the same number if
/// it is real; .T. or .F.; an entity; a token; the contents of a string, made by `stepText` if need be; or a
/// list of these
void appendParameter(std::string& text, double value);
void appendParameter(std::string& text, int value);
void appendParameter(std::string& text, bool value);
void appendParameter(std::string& text, StepId value);
void appendParameter(std::string& text, StepToken value);
void appendParameter(std::string& text, std::string_view value);
inline void appendParameter(std::string& text, const char* value) {
    appendParameter(text, std::string_view(value));
}
template <std::ranges::forward_range Values>
requires(!std::convertible_to<const Values&, std::string_view>) void appendParameter(std::string& text,
                                                                                     const Values& values) {
    text += '(';
    for (const auto& value : values) {
        appendParameter(text, value);
        text += ',';
    }
    if (!std::ranges::empty(values)) text.pop_back();
    text += ')';
}

/// A keyword with its parameters, such as DIRECTION('',(1.,0.,0.)).
template <class... Values>
[[nodiscard]] std::string stepRecord(std::string_view keyword, const Values&... values) {
    std::string text(keyword);
    text += '(';
    ((appendParameter(text, values), text += ','), ...);
    if (sizeof...(values) > 0) text.pop_back();
    return text + ')';
}

class StepFile {
public:
    template <class... Values> StepId add(std::string_view keyword, const Values&... values) {
        return addText(stepRecord(keyword, values...));
    }

    /// An entity of several types at once.
    /// \param records  one after the other, made by `stepRecord`
    StepId addComplex(std::string_view records);

    /// The whole file.
    /// \param name    of the file, made by `stepText`
    /// \param date    when it was made, such as "1970-01-01T00:00:00"
    /// \param schema  the name for FILE_SCHEMA
    [[nodiscard]] std::string text(std::string_view name, std::string_view date,
                                   std::string_view schema) const;

private:
    StepId addText(std::string_view entity);

    std::string data_;
    int count_ = 0;
};

} // namespace qm
