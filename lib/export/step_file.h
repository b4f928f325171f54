/// \file The entities of a STEP file (ISO 10303-21), as text, in order.
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

/// The contents of a string, between its quotation marks. A comma is written by its code, because lines are
/// broken after commas.
/// \param utf8   valid UTF-8
/// \param limit  in bytes; characters beyond it are left out
[[nodiscard]] std::string stepText(std::string_view utf8, std::size_t limit = std::string_view::npos);

/// Text of an entity in the making: `StepText("DIRECTION('',").reals(xyz).end()`.
class StepText {
public:
    explicit StepText(std::string_view begin) : text_(begin) {}

    StepText& raw(std::string_view text);
    /// With a decimal point, in the fewest digits that read back as the same number.
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
    std::string name; ///< of the file, made by `stepText`
    std::string date; ///< when it was made, such as "1970-01-01T00:00:00"
};

class StepFile {
public:
    /// \param entity  without its number and the semicolon
    StepId add(const StepText& entity);
    StepId add(std::string_view entity) { return add(StepText(entity)); }

    /// The whole file.
    /// \param schema  the name for FILE_SCHEMA
    [[nodiscard]] std::string text(const StepHeader& header, std::string_view schema) const;

private:
    std::string data_;
    int count_ = 0;
};

} // namespace qm
