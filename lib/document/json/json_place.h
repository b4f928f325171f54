/// \file A value in a document together with its JSON pointer, so that every error message names its place.
#pragma once

#include "base/at.h"
#include "document/json/json.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace qm {

/// Every function throws Error with the pointer of the place if the value is not of the required form. The
/// value must outlive the place.
class JsonPlace {
public:
    explicit JsonPlace(const Json& value, JsonPointer pointer = JsonPointer())
        : value_(&value), pointer_(std::move(pointer)) {}

    [[nodiscard]] const Json& value() const { return *value_; }
    [[nodiscard]] const JsonPointer& pointer() const { return pointer_; }
    [[nodiscard]] bool isNull() const { return value_->is_null(); }

    /// A member, which must exist.
    [[nodiscard]] JsonPlace operator[](const char* key) const;
    /// A member, if it exists.
    [[nodiscard]] std::optional<JsonPlace> find(const char* key) const;
    /// An element of an array.
    [[nodiscard]] JsonPlace operator[](std::size_t index) const;
    [[nodiscard]] JsonPlace operator[](int index) const { return (*this)[at(index)]; }
    /// The number of elements of an array.
    [[nodiscard]] std::size_t size() const;
    /// The elements of an array, each with its pointer; for arrays of objects, not of many numbers.
    [[nodiscard]] std::vector<JsonPlace> elements() const;

    [[nodiscard]] bool boolean() const;
    [[nodiscard]] const std::string& text() const;
    /// A finite number.
    [[nodiscard]] double number() const;
    /// A finite number, or nothing for null.
    [[nodiscard]] std::optional<double> numberOrNull() const;
    [[nodiscard]] std::int64_t whole(std::int64_t min = std::numeric_limits<std::int64_t>::min(),
                                     std::int64_t max = std::numeric_limits<std::int64_t>::max()) const;
    /// A whole number from 0 to `count` - 1.
    /// \param what  that it is the number of, for messages, such as "vertex"
    [[nodiscard]] int index(std::size_t count, const char* what) const;
    /// All elements of an array, each of them such a number.
    [[nodiscard]] std::vector<int> indices(std::size_t count, const char* what) const;

    /// Throws at the first difference from what must be here; further keys are allowed.
    void requireEqual(const Json& expected, const std::string& what, const std::string& remedy) const;

    [[noreturn]] void fail(const std::string& what, const std::string& remedy = {}) const;
    [[noreturn]] void failAt(std::size_t index, const std::string& what,
                             const std::string& remedy = {}) const;

private:
    void requireType(bool holds, const char* type) const;

    const Json* value_;
    JsonPointer pointer_;
};

/// Compares two values. Numbers are compared by value, and keys that only `actual` has are ignored.
/// \return the pointer of the first difference, which begins with `pointer`; nothing if there is none
[[nodiscard]] std::optional<JsonPointer> firstDifference(const Json& expected, const Json& actual,
                                                         const JsonPointer& pointer = JsonPointer());

} // namespace qm
