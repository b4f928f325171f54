/// \file Options in the form in which documents record them.
#pragma once

#include "document/json/json_place.h"
#include "document/options/options.h"

#include <cmath>
#include <type_traits>

namespace qm {

/// All options of a struct with their present values, by key; an infinite number, which means no limit,
/// becomes null.
template <class Options> [[nodiscard]] Json optionsToJson(Options options) {
    Json json = Json::object();
    describe(options, [&json](const char* name, const auto& value, const Range&, const char*) {
        using Value = std::remove_cvref_t<decltype(value)>;
        Json& entry = json[keyOf(name)];
        if constexpr (std::is_enum_v<Value>)
            entry = std::string(choiceName(value));
        else if constexpr (std::is_same_v<Value, Length>)
            entry = value.percent ? Json(lengthText(value)) : Json(value.value);
        else if constexpr (std::is_floating_point_v<Value>)
            entry = std::isfinite(value) ? Json(value) : Json();
        else if constexpr (std::is_same_v<Value, CostTerms>)
            entry = costText(value);
        else
            entry = value;
    });
    return json;
}

/// Reads the name of an enumeration's value.
template <class Enum> void readChoice(const JsonPlace& place, Enum& value) {
    if (!choiceValue(place.text(), value)) place.fail("'" + place.text() + "' is not known");
}

} // namespace qm
