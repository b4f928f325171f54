#include "document/schema_view.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace qm {

std::optional<std::int64_t> wholeNumber(const Json& value) {
    switch (value.type()) {
    case Json::value_t::number_integer:
        return value.get<std::int64_t>();
    case Json::value_t::number_unsigned: {
        const auto number = value.get<std::uint64_t>();
        if (number > static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max())) return {};
        return static_cast<std::int64_t>(number);
    }
    case Json::value_t::number_float: {
        constexpr double limit = 9007199254740992; // 2^53: every whole number up to here is a double
        const double number = value.get<double>();
        if (!(std::abs(number) <= limit) || number != std::floor(number)) return {};
        return static_cast<std::int64_t>(number);
    }
    default:
        return {};
    }
}

std::vector<std::size_t> shownElements(const Json::array_t& array) {
    constexpr std::size_t shortArray = 8;
    const auto all = [&array] {
        std::vector<std::size_t> positions(array.size());
        std::iota(positions.begin(), positions.end(), std::size_t{0});
        return positions;
    };
    if (array.size() <= shortArray) return all();

    std::vector<std::size_t> shown;
    std::size_t minAt = 0;
    std::size_t maxAt = 0;
    double minValue = std::numeric_limits<double>::infinity();
    double maxValue = -minValue;
    for (std::size_t i = 0; i < array.size(); ++i) {
        if (!array[i].is_number()) return all();
        if (shown.empty() && array[i].is_number_float() && !wholeNumber(array[i])) shown.push_back(i);
        const auto value = array[i].get<double>();
        if (value < minValue) {
            minValue = value;
            minAt = i;
        }
        if (value > maxValue) {
            maxValue = value;
            maxAt = i;
        }
    }
    shown.push_back(minAt);
    shown.push_back(maxAt);
    return shown;
}

namespace schema_view {

Adapter Array::const_iterator::operator*() const {
    const auto& array = array_->place_.value->get_ref<const Json::array_t&>();
    return Adapter(Place{&array[array_->shown_[rank_]], array_->place_.results});
}

valijson::adapters::DerefProxy<Adapter> Array::const_iterator::operator->() const {
    return valijson::adapters::DerefProxy<Adapter>(**this);
}

ObjectMember Object::const_iterator::operator*() const {
    const auto& [key, value] =
        place_.value->get_ref<const Json::object_t&>().begin()[static_cast<std::ptrdiff_t>(rank_)];
    return {key, Adapter(Place{&value, place_.results})};
}

valijson::adapters::DerefProxy<ObjectMember> Object::const_iterator::operator->() const {
    return valijson::adapters::DerefProxy<ObjectMember>(**this);
}

Object::const_iterator Object::find(const std::string& key) const {
    if (place_.value == nullptr) return end();
    const auto& members = place_.value->get_ref<const Json::object_t&>();
    const auto found = std::find_if(members.begin(), members.end(),
                                    [&key](const auto& member) { return member.first == key; });
    return {place_, static_cast<std::size_t>(found - members.begin())};
}

bool FrozenValue::equalTo(const valijson::adapters::Adapter& other, bool strict) const {
    return Adapter(value_).equalTo(other, strict);
}

Value::Value() {
    static const Json emptyObject = Json::object();
    place_.value = &emptyObject;
}

bool Value::getArraySize(std::size_t& result) const {
    if (isArray()) result = json().size();
    return isArray();
}

bool Value::getBool(bool& result) const {
    if (isBool()) result = json().get<bool>();
    return isBool();
}

bool Value::getDouble(double& result) const {
    if (isDouble()) result = json().get<double>();
    return isDouble();
}

bool Value::getInteger(std::int64_t& result) const {
    const std::optional<std::int64_t> number = wholeNumber(json());
    if (number) result = *number;
    return number.has_value();
}

bool Value::getObjectSize(std::size_t& result) const {
    if (isObject()) result = json().size();
    return isObject();
}

bool Value::getString(std::string& result) const {
    if (isString()) result = json().get_ref<const std::string&>();
    return isString();
}

} // namespace schema_view

} // namespace qm
