#include "document/json/json_place.h"

#include "base/error.h"
#include "document/json/whole_number.h"

namespace qm {

JsonPlace JsonPlace::operator[](const char* key) const {
    const std::optional<JsonPlace> member = find(key);
    if (!member) fail(std::string("lacks '") + key + "'");
    return *member;
}

std::optional<JsonPlace> JsonPlace::find(const char* key) const {
    if (!value_->is_object()) fail(std::string("is ") + value_->type_name() + ", not object");
    const auto member = value_->find(key);
    if (member == value_->end()) return {};
    return JsonPlace(*member, pointer_ / key);
}

JsonPlace JsonPlace::operator[](std::size_t index) const {
    if (index >= size()) fail("has only " + std::to_string(size()) + " entries");
    return JsonPlace((*value_)[index], pointer_ / index);
}

std::size_t JsonPlace::size() const {
    if (!value_->is_array()) fail(std::string("is ") + value_->type_name() + ", not array");
    return value_->size();
}

bool JsonPlace::boolean() const {
    if (!value_->is_boolean()) fail(std::string("is ") + value_->type_name() + ", not boolean");
    return value_->get<bool>();
}

const std::string& JsonPlace::text() const {
    if (!value_->is_string()) fail(std::string("is ") + value_->type_name() + ", not string");
    return value_->get_ref<const std::string&>();
}

double JsonPlace::number() const {
    if (!value_->is_number()) fail(std::string("is ") + value_->type_name() + ", not number");
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

std::vector<int> JsonPlace::indices(std::size_t count, const char* what) const {
    std::vector<int> result;
    result.reserve(size());
    for (std::size_t i = 0; i < size(); ++i) {
        const std::optional<std::int64_t> number = wholeNumber((*value_)[i]);
        if (!number) failAt(i, "is no whole number");
        if (*number < 0 || static_cast<std::uint64_t>(*number) >= count)
            failAt(i, std::string("there is no ") + what + " " + std::to_string(*number) + ", only 0 to " +
                          std::to_string(static_cast<std::int64_t>(count) - 1));
        result.push_back(static_cast<int>(*number));
    }
    return result;
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
