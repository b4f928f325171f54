/// \file Values out of JSON of which nothing is certain: what is missing or of another type is one that no
/// check accepts.
#pragma once

#include <nlohmann/json.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace qm::check {

using Json = nlohmann::ordered_json;

/// A member of an object; null if there is none.
[[nodiscard]] const Json& member(const Json& object, const char* key);
/// The elements of an array; none of anything else.
[[nodiscard]] const Json::array_t& elements(const Json& value);
[[nodiscard]] const Json& element(const Json& value, std::size_t rank);
[[nodiscard]] std::optional<double> number(const Json& value);
/// NaN for what is no number: no comparison accepts it.
[[nodiscard]] double numberOrNan(const Json& value);
/// -1 for what is no whole number from 0 on that an index can hold.
[[nodiscard]] int whole(const Json& value);
[[nodiscard]] std::optional<int> wholeIfAny(const Json& value);
[[nodiscard]] std::optional<std::string> text(const Json& value);
[[nodiscard]] bool isTrue(const Json& value);
[[nodiscard]] std::vector<int> wholes(const Json& value);

/// What `read` makes of the elements of an array; none of anything else.
template <class Part, class Read> [[nodiscard]] std::vector<Part> all(const Json& list, const Read& read) {
    std::vector<Part> parts;
    parts.reserve(elements(list).size());
    for (const Json& each : elements(list))
        parts.push_back(read(each));
    return parts;
}

} // namespace qm::check
