/// \file Entities of a STEP file (ISO 10303-21), one after the other, as text.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>

namespace qm {

/// The number of an entity, as others refer to it.
struct StepId {
    int number = 0;
};

/// What stands between the quotation marks of a string. A comma is written by its number, as lines are broken
/// after commas.
/// \param utf8  valid
/// \param limit  of bytes; letters at the end are left out that are beyond it
[[nodiscard]] std::string stepText(std::string_view utf8, std::size_t limit = std::string_view::npos);

/// Text of an entity in the making: `StepText("DIRECTION('',").reals(xyz).end()`.
class StepText {
public:
    explicit StepText(std::string_view begin) : text_(begin) {}

    StepText& raw(std::string_view text);
    /// With a decimal point, in as few digits as read back as the same number.
    StepText& real(double value);
    StepText& integer(int value);
    StepText& flag(bool value); ///< .T. or .F.
    StepText& id(StepId entity);
    /// Lists in parentheses.
    StepText& reals(std::span<const double> values);
    StepText& reals(std::initializer_list<double> values) {
        return reals(std::span(values.begin(), values.size()));
    }
    StepText& integers(std::span<const int> values);
    StepText& ids(std::span<const StepId> entities);

    [[nodiscard]] const std::string& text() const { return text_; }

private:
    std::string text_;
};

struct StepHeader {
    std::string name; ///< of the file, as `stepText` makes it
    std::string date; ///< when it was made, such as "1970-01-01T00:00:00"
};

class StepFile {
public:
    /// \param entity  without its number and the semicolon
    StepId add(const StepText& entity);
    StepId add(std::string_view entity) { return add(StepText(entity)); }

    /// The whole file.
    /// \param schema  as FILE_SCHEMA has it
    [[nodiscard]] std::string text(const StepHeader& header, std::string_view schema) const;

private:
    std::string data_;
    int count_ = 0;
};

} // namespace qm
