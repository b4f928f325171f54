#include "check/document/json_values.h"

#include <cmath>
#include <limits>

namespace qm::check {

const Json& member(const Json& object, const char* key) {
    static const Json none;
    if (!object.is_object()) return none;
    const auto found = object.find(key);
    return found == object.end() ? none : *found;
}

const Json::array_t& elements(const Json& value) {
    static const Json::array_t none;
    return value.is_array() ? value.get_ref<const Json::array_t&>() : none;
}

const Json& element(const Json& value, std::size_t rank) {
    static const Json none;
    return rank < elements(value).size() ? elements(value)[rank] : none;
}

std::optional<double> number(const Json& value) {
    return value.is_number() ? std::optional(value.get<double>()) : std::nullopt;
}

double numberOrNan(const Json& value) {
    return number(value).value_or(std::numeric_limits<double>::quiet_NaN());
}

int whole(const Json& value) {
    const double figure = numberOrNan(value);
    const bool fits =
        figure >= 0 && figure <= std::numeric_limits<int>::max() && figure == std::floor(figure);
    return fits ? static_cast<int>(figure) : -1;
}

std::optional<int> wholeIfAny(const Json& value) {
    return value.is_null() ? std::nullopt : std::optional(whole(value));
}

std::optional<std::string> text(const Json& value) {
    return value.is_string() ? std::optional(value.get<std::string>()) : std::nullopt;
}

bool isTrue(const Json& value) {
    return value.is_boolean() && value.get<bool>();
}

std::vector<int> wholes(const Json& value) {
    std::vector<int> result;
    result.reserve(elements(value).size());
    for (const Json& each : elements(value))
        result.push_back(whole(each));
    return result;
}

} // namespace qm::check
