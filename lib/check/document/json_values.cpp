#include "check/document/json_values.h"

#include <cmath>
#include <limits>

namespace qm::check {

JsonValue JsonValue::none() {
    static const Json null;
    return JsonValue(null);
}

JsonValue JsonValue::operator[](const std::string& key) const {
    if (!isObject()) return none();
    const auto found = value_->find(key);
    return found == value_->end() ? none() : JsonValue(*found);
}

JsonValue JsonValue::operator[](std::size_t rank) const {
    return rank < size() ? JsonValue((*value_)[rank]) : none();
}

std::optional<double> JsonValue::number() const {
    return value_->is_number() ? std::optional(value_->get<double>()) : std::nullopt;
}

double JsonValue::numberOrNan() const {
    return number().value_or(std::numeric_limits<double>::quiet_NaN());
}

int JsonValue::whole() const {
    const double figure = numberOrNan();
    const bool fits =
        figure >= 0 && figure <= std::numeric_limits<int>::max() && figure == std::floor(figure);
    return fits ? static_cast<int>(figure) : -1;
}

std::optional<int> JsonValue::wholeIfAny() const {
    return isNull() ? std::nullopt : std::optional(whole());
}

std::optional<std::string> JsonValue::text() const {
    return value_->is_string() ? std::optional(value_->get<std::string>()) : std::nullopt;
}

std::map<std::string, double, std::less<>> JsonValue::numbers() const {
    std::map<std::string, double, std::less<>> result;
    if (isObject())
        for (const auto& [name, value] : value_->items())
            if (const auto figure = JsonValue(value).number()) result.emplace(name, *figure);
    return result;
}

} // namespace qm::check
