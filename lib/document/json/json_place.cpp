#include "document/json/json_place.h"

#include "base/error.h"

#include <utility>

namespace qm {
namespace {

std::string noSuch(const char* what, std::int64_t number, std::size_t count) {
    return std::string("there is no ") + what + " " + std::to_string(number) + ", only 0 to " +
           std::to_string(static_cast<std::int64_t>(count) - 1);
}

} // namespace

JsonPlace JsonPlace::operator[](const char* key) const {
    const std::optional<JsonPlace> member = find(key);
    if (!member) fail(std::string("lacks '") + key + "'");
    return *member;
}

std::optional<JsonPlace> JsonPlace::find(const char* key) const {
    requireType(value_->is_object(), "object");
    const auto member = value_->find(key);
    if (member == value_->end()) return {};
    return JsonPlace(*member, pointer_ / key);
}

JsonPlace JsonPlace::operator[](std::size_t index) const {
    if (index >= size()) fail("has only " + std::to_string(size()) + " entries");
    return JsonPlace((*value_)[index], pointer_ / index);
}

std::size_t JsonPlace::size() const {
    requireType(value_->is_array(), "array");
    return value_->size();
}

std::vector<JsonPlace> JsonPlace::elements() const {
    std::vector<JsonPlace> result;
    result.reserve(size());
    for (std::size_t i = 0; i < size(); ++i)
        result.push_back((*this)[i]);
    return result;
}

bool JsonPlace::boolean() const {
    requireType(value_->is_boolean(), "boolean");
    return value_->get<bool>();
}

const std::string& JsonPlace::text() const {
    requireType(value_->is_string(), "string");
    return value_->get_ref<const std::string&>();
}

double JsonPlace::number() const {
    requireType(value_->is_number(), "number");
    return value_->get<double>();
}

std::optional<double> JsonPlace::numberOrNull() const {
    return isNull() ? std::nullopt : std::optional<double>(number());
}

std::int64_t JsonPlace::whole(std::int64_t min, std::int64_t max) const {
    const std::optional<std::int64_t> number = wholeNumber(*value_);
    if (!number) fail("is no whole number");
    if (*number < min) fail("is less than " + std::to_string(min));
    if (*number > max) fail("is more than " + std::to_string(max));
    return *number;
}

int JsonPlace::index(std::size_t count, const char* what) const {
    const std::int64_t number = whole();
    if (number < 0 || std::cmp_greater_equal(number, count)) fail(noSuch(what, number, count));
    return static_cast<int>(number);
}

std::vector<int> JsonPlace::indices(std::size_t count, const char* what) const {
    std::vector<int> result;
    result.reserve(size());
    for (std::size_t i = 0; i < size(); ++i) {
        const std::optional<std::int64_t> number = wholeNumber((*value_)[i]);
        if (!number) failAt(i, "is no whole number");
        if (*number < 0 || std::cmp_greater_equal(*number, count)) failAt(i, noSuch(what, *number, count));
        result.push_back(static_cast<int>(*number));
    }
    return result;
}

void JsonPlace::requireEqual(const Json& expected, const std::string& what, const std::string& remedy) const {
    if (const auto difference = firstDifference(expected, *value_, pointer_))
        throw Error(difference->to_string(), what, remedy);
}

void JsonPlace::requireType(bool holds, const char* type) const {
    if (!holds) fail(std::string("is ") + value_->type_name() + ", not " + type);
}

void JsonPlace::fail(const std::string& what, const std::string& remedy) const {
    throw Error(pointer_.empty() ? "/" : pointer_.to_string(), what, remedy);
}

void JsonPlace::failAt(std::size_t index, const std::string& what, const std::string& remedy) const {
    throw Error((pointer_ / index).to_string(), what, remedy);
}

std::optional<JsonPointer> firstDifference(const Json& expected, const Json& actual,
                                           const JsonPointer& pointer) {
    if (expected.is_object() && actual.is_object()) {
        for (const auto& [key, value] : expected.items()) {
            const JsonPointer place = pointer / key;
            const auto member = actual.find(key);
            if (member == actual.end()) return place;
            if (auto difference = firstDifference(value, *member, place)) return difference;
        }
        return {};
    }
    if (expected.is_array() && actual.is_array()) {
        const std::size_t common = std::min(expected.size(), actual.size());
        for (std::size_t i = 0; i < common; ++i) {
            if (expected[i].is_number() && expected[i] == actual[i]) continue;
            if (auto difference = firstDifference(expected[i], actual[i], pointer / i)) return difference;
        }
        if (expected.size() != actual.size()) return pointer / common;
        return {};
    }
    if (expected == actual) return {};
    return pointer;
}

} // namespace qm
