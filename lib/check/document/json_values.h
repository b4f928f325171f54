/// \file Values out of JSON of which nothing is certain: what is missing or of another type is one that no
/// check accepts.
#pragma once

#include <nlohmann/json.hpp>

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace qm::check {

using Json = nlohmann::ordered_json;

/// A value somewhere in a document, which must outlive this; null where the document has none.
class JsonValue {
public:
    explicit JsonValue(const Json& value) : value_(&value) {}
    /// What is not there.
    [[nodiscard]] static JsonValue none();

    /// A member of an object; null if there is none.
    [[nodiscard]] JsonValue operator[](const std::string& key) const;
    /// An element of an array; null if there is none.
    [[nodiscard]] JsonValue operator[](std::size_t rank) const;
    /// Of an array; 0 for anything else.
    [[nodiscard]] std::size_t size() const { return value_->is_array() ? value_->size() : 0; }

    [[nodiscard]] bool isNull() const { return value_->is_null(); }
    [[nodiscard]] bool isArray() const { return value_->is_array(); }
    [[nodiscard]] bool isObject() const { return value_->is_object(); }
    [[nodiscard]] bool isTrue() const { return value_->is_boolean() && value_->get<bool>(); }

    [[nodiscard]] std::optional<double> number() const;
    /// NaN for what is no number: no comparison accepts it.
    [[nodiscard]] double numberOrNan() const;
    /// -1 for what is no whole number from 0 on that an index can hold.
    [[nodiscard]] int whole() const;
    [[nodiscard]] std::optional<int> wholeIfAny() const;
    [[nodiscard]] std::optional<std::string> text() const;

    /// What `read` makes of the elements of an array; none of anything else.
    template <class Read> [[nodiscard]] auto all(const Read& read) const {
        std::vector<std::invoke_result_t<Read, JsonValue>> parts;
        parts.reserve(size());
        for (std::size_t k = 0; k < size(); ++k)
            parts.push_back(std::invoke(read, (*this)[k]));
        return parts;
    }
    [[nodiscard]] std::vector<int> wholes() const { return all(&JsonValue::whole); }

    /// What `read` makes of the first elements of an array, as many as there have to be.
    template <std::size_t Count, class Read> [[nodiscard]] auto first(const Read& read) const {
        std::array<std::invoke_result_t<Read, JsonValue>, Count> parts;
        for (std::size_t k = 0; k < Count; ++k)
            parts[k] = std::invoke(read, (*this)[k]);
        return parts;
    }

    /// The numbers among the members of an object, by name.
    [[nodiscard]] std::map<std::string, double, std::less<>> numbers() const;

private:
    const Json* value_;
};

} // namespace qm::check
