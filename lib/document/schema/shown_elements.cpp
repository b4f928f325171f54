#include "document/schema/shown_elements.h"

#include "base/positions.h"

#include <algorithm>
#include <numeric>

namespace qm {

std::vector<std::size_t> shownElements(const Json::array_t& array) {
    constexpr std::size_t shortArray = 8;
    const auto all = [&array] {
        std::vector<std::size_t> positions(array.size());
        std::iota(positions.begin(), positions.end(), std::size_t{0});
        return positions;
    };
    if (array.size() <= shortArray) return all();

    if (!std::ranges::all_of(array, &Json::is_number)) return all();
    const auto isFraction = [](const Json& number) {
        return number.is_number_float() && !wholeNumber(number);
    };
    const auto value = [](const Json& number) { return number.get<double>(); };
    std::vector<std::size_t> shown;
    const auto fraction = std::ranges::find_if(array, isFraction);
    if (fraction != array.end()) shown.push_back(positionIn(array, fraction));
    shown.push_back(positionIn(array, std::ranges::min_element(array, {}, value)));
    shown.push_back(positionIn(array, std::ranges::max_element(array, {}, value)));
    return shown;
}

} // namespace qm
