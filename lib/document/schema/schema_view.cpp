#include "document/schema/schema_view.h"

#include "base/positions.h"

#include <algorithm>

namespace qm {

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
    const auto found =
        std::ranges::find_if(members, [&key](const auto& member) { return member.first == key; });
    return {place_, positionIn(members, found)};
}

bool FrozenValue::equalTo(const valijson::adapters::Adapter& other, bool strict) const {
    return Adapter(value_).equalTo(other, strict); // NOLINT(clang-analyzer-*): branches of the library
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
