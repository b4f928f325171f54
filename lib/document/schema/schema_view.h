/// \file A view of a document for Valijson.
///
/// Valijson visits every element of every array, which takes several microseconds each, and reports one error
/// per element. This view limits both: it shows at most three elements of a long array of numbers (see
/// `shown_elements.h`), and nothing after the first error.
#pragma once

#include "base/at.h"
#include "document/json/json.h"
#include "document/schema/shown_elements.h"

#include <valijson/internal/adapter.hpp>
#include <valijson/internal/basic_adapter.hpp>
#include <valijson/internal/frozen_value.hpp>
#include <valijson/validation_results.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace qm {

namespace schema_view {

class Adapter;

/// A value, and the place where errors are collected.
struct Place {
    const Json* value = nullptr;
    const valijson::ValidationResults* results = nullptr;
    [[nodiscard]] bool stopped() const { return results != nullptr && results->numErrors() > 0; }
};

class Array {
public:
    class const_iterator { // NOLINT(readability-identifier-naming): as containers call it
    public:
        const_iterator(const Array* array, std::size_t rank) : array_(array), rank_(rank) {}
        Adapter operator*() const;
        [[nodiscard]] valijson::adapters::DerefProxy<Adapter> operator->() const;
        const_iterator& operator--() {
            --rank_;
            return *this;
        }
        const_iterator& operator++() {
            ++rank_;
            return *this;
        }
        const_iterator operator++(int) { return {array_, rank_++}; }
        void advance(std::ptrdiff_t count) { rank_ += at(count); }
        bool operator==(const const_iterator& other) const { return rank_ == other.rank_; }
        bool operator!=(const const_iterator& other) const {
            return rank_ != other.rank_ && !array_->place_.stopped();
        }

    private:
        const Array* array_;
        std::size_t rank_;
    };
    using iterator = const_iterator;

    Array() = default;
    explicit Array(Place place)
        : place_(place), shown_(shownElements(place.value->get_ref<const Json::array_t&>())) {}
    [[nodiscard]] const_iterator begin() const { return {this, 0}; }
    [[nodiscard]] const_iterator end() const { return {this, shown_.size()}; }
    /// The size of the whole array, for limits on its length.
    [[nodiscard]] std::size_t size() const { return place_.value == nullptr ? 0 : place_.value->size(); }

private:
    Place place_;
    std::vector<std::size_t> shown_;
};

using ObjectMember = std::pair<std::string, Adapter>;

class Object {
public:
    class const_iterator { // NOLINT(readability-identifier-naming): as containers call it
    public:
        const_iterator(Place place, std::size_t rank) : place_(place), rank_(rank) {}
        ObjectMember operator*() const;
        [[nodiscard]] valijson::adapters::DerefProxy<ObjectMember> operator->() const;
        const_iterator& operator++() {
            ++rank_;
            return *this;
        }
        bool operator==(const const_iterator& other) const { return rank_ == other.rank_; }
        bool operator!=(const const_iterator& other) const { return rank_ != other.rank_; }

    private:
        Place place_;
        std::size_t rank_;
    };
    using iterator = const_iterator;

    Object() = default;
    explicit Object(Place place) : place_(place) {}
    [[nodiscard]] const_iterator begin() const { return {place_, 0}; }
    [[nodiscard]] const_iterator end() const { return {place_, size()}; }
    [[nodiscard]] const_iterator find(const std::string& key) const;
    [[nodiscard]] std::size_t size() const { return place_.value == nullptr ? 0 : place_.value->size(); }

private:
    Place place_;
};

class FrozenValue : public valijson::adapters::FrozenValue {
public:
    explicit FrozenValue(Json value) : value_(std::move(value)) {}
    [[nodiscard]] valijson::adapters::FrozenValue* clone() const override { return new FrozenValue(value_); }
    [[nodiscard]] bool equalTo(const valijson::adapters::Adapter& other, bool strict) const override;

private:
    Json value_;
};

/// The interface that BasicAdapter requires of a value.
class Value {
public:
    Value();
    explicit Value(Place place) : place_(place) {}

    [[nodiscard]] valijson::adapters::FrozenValue* freeze() const { return new FrozenValue(json()); }
    [[nodiscard]] std::optional<Array> getArrayOptional() const {
        return isArray() ? std::optional<Array>(place_) : std::nullopt;
    }
    bool getArraySize(std::size_t& result) const;
    bool getBool(bool& result) const;
    bool getDouble(double& result) const;
    bool getInteger(std::int64_t& result) const;
    [[nodiscard]] std::optional<Object> getObjectOptional() const {
        return isObject() ? std::optional<Object>(place_) : std::nullopt;
    }
    bool getObjectSize(std::size_t& result) const;
    bool getString(std::string& result) const;
    [[nodiscard]] static bool hasStrictTypes() { return true; }
    [[nodiscard]] bool isArray() const { return json().is_array(); }
    [[nodiscard]] bool isBool() const { return json().is_boolean(); }
    [[nodiscard]] bool isDouble() const { return json().is_number() && !wholeNumber(json()); }
    [[nodiscard]] bool isInteger() const { return wholeNumber(json()).has_value(); }
    [[nodiscard]] bool isNull() const { return json().is_null(); }
    [[nodiscard]] bool isNumber() const { return json().is_number(); }
    [[nodiscard]] bool isObject() const { return json().is_object(); }
    [[nodiscard]] bool isString() const { return json().is_string(); }

private:
    [[nodiscard]] const Json& json() const { return *place_.value; }
    Place place_;
};

class Adapter : public valijson::adapters::BasicAdapter<Adapter, Array, ObjectMember, Object, Value> {
public:
    Adapter() = default;
    explicit Adapter(Place place) : BasicAdapter(Value(place)) {}
    /// For the schemas themselves: without a limit on errors.
    explicit Adapter(const Json& value) : Adapter(Place{&value, nullptr}) {}
};

} // namespace schema_view

} // namespace qm

/// Tells Valijson's schema parser the type of a schema's document.
template <> struct valijson::adapters::AdapterTraits<qm::schema_view::Adapter> {
    using DocumentType = qm::Json;
    static std::string adapterName() { return "quadmesh"; }
};
